#pragma once
// What a way of modelling gets wrong on the very body: each act's displacements at rest against a reference.
//
// The reference is tissue's law in quadratic elements on the body's own mesh with every tetrahedron divided
// into eight; on large meshes undivided, which judges linear elements only. So what is told is mechanics'
// part. That the mesh is another shape than the one imaged is another matter.
//
// The undivided reference tells how far the divided one is from settled. That is a third of their difference,
// since displacements converge at second order at least. Where a body's own law turns it inside out, or
// nothing settles, the error is `collapsed`: there is nothing to be near to.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/accuracy/act.h"
#include "server/accuracy/displacement.h"
#include "server/accuracy/foot.h"

namespace prosector {

/// The error of what is inside out, or nowhere at rest: no displacement is off by so much.
inline constexpr double collapsed = 1e3;

struct ActError {
  std::string act;
  double error = 0;      // of displacements, fraction; at least collapsed: it collapsed, or didn't settle
  double unsettled = 0;  // of it, what the reference itself may be off
};

/// Returns the act with the largest error; there must be one.
const ActError& worst(const std::vector<ActError>& acts);

/// The law that tissue is taken for where an author names none.
inline constexpr const char* tissue_law = "fem_neo_hookean";

struct TrialSettings {
  std::string law = tissue_law;  // the reference's
  std::size_t most_tets = 6000;  // of the reference
  int presses = 6;               // places that a fingertip presses
  bool tilts = true;             // whether a free body is tilted, too
  double weight = 1;             // of the body, times its own
  /// Called before each step of solving; may throw to give up.
  std::function<void()> before_step = {};
};

class BodyTrial {
 public:
  /// Finds the reference on `mesh`, in the world frame, whose surface is not used.
  BodyTrial(const SoftDesc& desc, const Vec3& gravity, Anatomy mesh, const TrialSettings& settings);
  ~BodyTrial();
  BodyTrial(BodyTrial&&) noexcept;

  /// Tells whether quadratic elements can be judged, too.
  bool judges_quadratic() const { return divided_; }
  /// Returns what model and element get wrong, act by act, with the reference's own part in it. Throws
  /// std::logic_error for quadratic elements that can't be judged.
  std::vector<ActError> measure(const std::string& model, const std::string& element) const;
  const std::vector<Act>& acts() const { return acts_; }

 private:
  struct Solved;
  void leave_out_unborne();
  std::unique_ptr<Solved> solve(const std::string& model, const std::string& element,
                                const Anatomy& mesh) const;
  double difference(std::size_t act, const Solved& one, const Solved& other) const;

  SoftDesc desc_;
  Anatomy mesh_;
  bool divided_;
  std::vector<std::optional<Foot>> feet_;  // by act
  std::vector<Act> acts_;
  std::function<void()> before_step_;
  std::vector<Vec3> places_;
  std::unique_ptr<Solved> reference_;
  std::vector<double> unsettled_;  // by act
};

}  // namespace prosector
