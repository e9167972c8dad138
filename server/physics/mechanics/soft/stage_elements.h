#pragma once
// Linearised elements of a body within a stage of a step.
//
// The stage's first evaluation point fixes the stiffness used by stiffness-proportional damping: the warped
// stiffness (linear elastic, rotated with each element) at that point. Newton's matrix is assembled at the
// last evaluation point. Models with rotated elements store these in single precision (corotated_elements.h).
// Other models, and cases in which single precision is not sufficient, use blocks in double precision.

#include <optional>
#include <span>
#include <vector>

#include "server/physics/mechanics/soft/matrices/corotated_stiffness.h"
#include "server/physics/mechanics/soft/soft_system.h"

namespace prosector {

class StageElements {
 public:
  /// Takes the system; the objects it refers to must outlive this one. `in_double`: allocates blocks now
  /// instead of when they are first needed.
  StageElements(const SoftSystem& system, bool in_double);
  /// Updates the object for the present system; discards cached data.
  void fit();

  /// Begins a stage. Positions x are 3n, m. `start`: the step's start, which must outlive the stage.
  /// `single`: whether single precision is sufficient.
  void begin_stage(const VecX& start, double scale, bool single);
  /// Returns whether this stage uses rotated elements.
  bool turned() const { return rotated_ && single_; }

  // ---- Rotated elements
  /// Computes all cached data of the elements at x in one pass.
  void linearise(const Eigen::Ref<const VecX>& x);
  /// Assembles K at x into `rows`.
  void assemble(const Eigen::Ref<const VecX>& x, SymmetricRows& rows);
  /// Returns whether x is so close to this stage's last assemble() that its matrix is still a good
  /// approximation.
  bool near_assembled(const Eigen::Ref<const VecX>& x) const;
  bool near_start(const Eigen::Ref<const VecX>& x) const;

  // ---- Damping: K at the stage's first evaluation point, which is x if there was none before.
  /// Returns ½uᵀKu.
  double damping_energy(const Eigen::Ref<const VecX>& x, const VecX& u);
  /// Returns ½uᵀKu and computes f = K·u.
  double damping_forces(const Eigen::Ref<const VecX>& x, const VecX& u, VecX& f);
  /// Returns the blocks of K; not for rotated elements.
  std::span<const Mat3> damping_blocks(const Eigen::Ref<const VecX>& x);

 private:
  /// Rotated elements and the positions at which they were computed.
  struct Linearised {
    CorotatedElements elements;
    VecX at;
    bool known = false;
  };
  Eigen::Ref<const VecX> somewhere(const Eigen::Ref<const VecX>& x) const;
  void find(const Eigen::Ref<const VecX>& x, Linearised& out);
  bool near(const Eigen::Ref<const VecX>& x, const VecX& there) const;

  SoftSystem system_;
  std::optional<CorotatedStiffness> rotated_;  // for models with rotated elements
  const VecX* start_ = nullptr;
  double scale_ = 1;
  bool single_ = false;
  Linearised first_, later_;
  const Linearised* present_ = nullptr;    // the one computed last
  const Linearised* assembled_ = nullptr;  // the one used by the last matrix
  std::vector<Mat3> blocks_;               // K at the first evaluation point
  bool blocks_known_ = false;
};

}  // namespace prosector
