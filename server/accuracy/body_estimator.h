#pragma once
// Estimator of the error of a body's present state, from its own stresses: cheap enough to run again and
// again while users touch the body. It does not change the body.
//
// Discretisation. The body's stress is tested with the hierarchical functions that its elements lack first
// (bubbles.h). The residual r_k of function k and the function's own stiffness K_k give the energy that it
// would add:
//   η² = Σ_k r_k·K_k⁻¹·r_k
// K_k is Hooke's stiffness, rotated with the tissue. Its volumetric part acts on an element's mean, as far as
// that of the elements does (mean_dilatation.h). The work of the loads, C = f·u, is below its true value by
// η² where there is no other error.
//
// Model. The difference between the work of the body's law and of tissue's law at the present strains
// (law_difference.h).
//
// Both are relative to 2W = Σ V·P:(F − R), which equals C where strains are small. With these relative errors
// d and m, the true value is C·(1 + d + m). A force at a given depth is too large by d + m. The displacement
// under a load is too small by (d + m)/(1 + d + m).
//
// Time. The strain energy of the position error of the last tick's step, over that of the body, as its square
// root.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/error_estimate.h"
#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// State of a body at one time.
struct BodyMoment {
  VecX x;             // 3n, m
  VecX acceleration;  // 3n, m/s²: gravity's less the nodes' own, over the users' factor on stiffness
  VecX slip;          // 3n, m: position error of the nodes from the length of the last step
  double solver = 0;  // position error of the nodes from the last solve, over their displacement
  double give = 0;    // J: work of the pressing forces over their depth in the body: the contact's own dent
};

struct Estimate {
  double error = 0;           // relative error of the displacements under the loads
  ErrorParts parts;           // `error` is |discretisation + model| + solver + time
  double press = 0;           // relative error of the force felt by loads added since keep_as_quiet()
  double pressed = 0;         // work of these loads over that of all loads
  std::vector<double> local;  // by vertex: the mean over the volume is `error`
};

class BodyEstimator {
 public:
  /// Returns whether bodies of that description can be estimated: tetrahedra with a constitutive law.
  static bool judges(const SoftDesc& desc, const TetMesh& mesh);

  /// Makes an estimator for a body with the rest shape `mesh` (world frame; for quadratic elements with the
  /// edge midpoints among its nodes). `ties`: stiffness that ties each node, n, N/m. `tissue`: the law that
  /// tissue is assumed to follow.
  BodyEstimator(const SoftDesc& desc, const TetMesh& mesh, const VecX& ties, const std::string& tissue);
  ~BodyEstimator();
  BodyEstimator(BodyEstimator&&) noexcept;

  /// Returns the number of pieces of work in an estimate, each of about a microsecond.
  std::size_t pieces() const;
  /// Begins an estimate of that state, which is swapped in.
  void begin(BodyMoment& moment);
  /// Runs up to that many pieces. Returns whether the estimate is complete. Allocates nothing.
  bool go_on(std::size_t pieces);
  /// Returns the last complete estimate.
  const Estimate& newest() const;

  /// Stores the state of the newest estimate as unpressed: loads added later count as a press.
  void keep_as_quiet();
  const TetMesh& mesh() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace prosector
