#pragma once
// A body's elements as linearised within a stage of a step.
//
// Where a stage is first asked about fixes what stiffness-proportional damping multiplies with: Hooke's
// stiffness, turned with each element as it is there. The last place asked about is what Newton's matrix is
// made of. Elements that turn are kept as that, in single precision (turned_elements.h); others, and where
// single precision won't do, as blocks in double.

#include <optional>
#include <span>
#include <vector>

#include "server/physics/soft/matrices/turned_stiffness.h"
#include "server/physics/soft/soft_system.h"

namespace prosector {

class StageElements {
 public:
  /// Takes the system; what it refers to must outlive this. `in_double`: whether blocks will be asked for
  /// from the start; else they are made when they are.
  StageElements(const SoftSystem& system, bool in_double);
  /// Fits to the system as it is; nothing is known.
  void fit();

  /// Positions x are 3n, m. `start`: the step's, which must outlive the stage. `single`: whether single
  /// precision will do.
  void begin_stage(const VecX& start, double scale, bool single);
  /// Tells whether elements are kept as turned ones in this stage.
  bool turned() const { return turned_ && single_; }

  // ---- Turned elements
  /// Finds everything that is known of the elements, at x, in one pass.
  void linearise(const Eigen::Ref<const VecX>& x);
  /// Assembles K at x into `rows`.
  void assemble(const Eigen::Ref<const VecX>& x, SymmetricRows& rows);
  /// Tells whether x is where this stage's last assemble() still describes the body.
  bool near_assembled(const Eigen::Ref<const VecX>& x) const;
  bool near_start(const Eigen::Ref<const VecX>& x) const;

  // ---- Damping: K as it is at the stage's first place, which is x unless there was one.
  /// Returns ½uᵀKu.
  double damping_energy(const Eigen::Ref<const VecX>& x, const VecX& u);
  /// Returns ½uᵀKu and computes f = K·u.
  double damping_forces(const Eigen::Ref<const VecX>& x, const VecX& u, VecX& f);
  /// Returns K's blocks; not of turned elements.
  std::span<const Mat3> damping_blocks(const Eigen::Ref<const VecX>& x);

 private:
  /// Turned elements, and the positions they are at.
  struct Linearised {
    TurnedElements elements;
    VecX at;
    bool known = false;
  };
  Eigen::Ref<const VecX> somewhere(const Eigen::Ref<const VecX>& x) const;
  void find(const Eigen::Ref<const VecX>& x, Linearised& out);
  bool near(const Eigen::Ref<const VecX>& x, const VecX& there) const;

  SoftSystem system_;
  std::optional<TurnedStiffness> turned_;  // of models that turn
  const VecX* start_ = nullptr;
  double scale_ = 1;
  bool single_ = false;
  Linearised first_, later_;
  const Linearised* present_ = nullptr;    // the last of them
  const Linearised* assembled_ = nullptr;  // of the last matrix
  std::vector<Mat3> blocks_;               // K at the first place
  bool blocks_known_ = false;
};

}  // namespace prosector
