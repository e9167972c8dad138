#pragma once
// An estimate of what is wrong with a body as it is now, from its own stresses: cheap enough to be found anew
// while people touch it. Nothing here changes the body.
//
// Discretisation. The body's stress is tested with the functions that its elements leave out first
// (bubbles.h). The residual r_k of function k, over the function's own stiffness K_k, tells how much it would
// take up:
//   η² = Σ_k r_k·K_k⁻¹·r_k
// K_k is Hooke's stiffness, turned with the tissue, its volumetric part by the mean over an element as far as
// elements do so (mean_dilatation.h). What loads do, C = f·u, is short of the truth by η² where nothing else
// is wrong.
//
// Model. The work that tissue's law would do otherwise at the strains that occur (law_difference.h).
//
// Both are over 2W = Σ V·P:(F − R), which C is where strains are small. With d and m so found, the truth is
// C·(1 + d + m). A force at a given depth is too large by d + m; how far a load moves the body is too little
// by (d + m)/(1 + d + m).
//
// Time. The strain energy of how far the last tick's step is off, over the body's, as its root.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/mesh.h"
#include "common/messages.h"
#include "common/scene/scene.h"

namespace prosector {

/// A body at a moment.
struct BodyMoment {
  VecX x;             // 3n, m
  VecX acceleration;  // 3n, m/s²: gravity's less the nodes' own, over how stiff people made the body
  VecX slip;          // 3n, m: how far the last step's length put the nodes wrong
  double solver = 0;  // how far the last solve left the nodes wrong, over how far they are from rest
  double give = 0;    // J: work of what presses it over how far that is in it: contact's own dent
};

struct Estimate {
  double error = 0;           // of how far its loads move the body
  ErrorParts parts;           // discretisation + model, and what they leave of solver and time, are `error`
  double press = 0;           // of the force that is felt, of what was done to it since keep_as_quiet()
  double pressed = 0;         // the work of that, over what all loads do
  std::vector<double> local;  // by vertex: their mean over the volume is `error`
};

class BodyEstimator {
 public:
  /// Tells whether bodies that are described so can be judged: of tetrahedra with a law.
  static bool judges(const SoftDesc& desc, const TetMesh& mesh);

  /// Makes it for a body that rests as `mesh` (world frame; of quadratic elements with the middles of edges
  /// among its nodes), its nodes tied by `ties` (n, N/m). `tissue`: the law that tissue is taken for.
  BodyEstimator(const SoftDesc& desc, const TetMesh& mesh, const VecX& ties, const std::string& tissue);
  ~BodyEstimator();
  BodyEstimator(BodyEstimator&&) noexcept;

  /// Returns how many pieces of work an estimate is, each a microsecond or so.
  std::size_t pieces() const;
  /// Begins an estimate of the body at that moment, which is taken over by a swap.
  void begin(BodyMoment& moment);
  /// Goes on by so many pieces. Returns whether the estimate is there. Allocates nothing.
  bool go_on(std::size_t pieces);
  /// Returns the last one that is there.
  const Estimate& newest() const;

  /// Takes the body of the newest estimate for one that nothing presses: what comes on top is a press.
  void keep_as_quiet();
  const TetMesh& mesh() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace prosector
