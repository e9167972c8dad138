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

namespace prosector::soft {

class StageElements {
 public:
  /// Initialises the elements for the equations of `system`; the objects that it refers to must outlive this
  /// object. `in_double`: allocates the double-precision blocks of the damping matrix now instead of when
  /// first needed.
  StageElements(const SoftSystem& system, bool in_double);
  /// Resizes all arrays after the body's mesh changed and discards cached element data.
  void fit();

  /// Begins a stage (one minimisation of an implicit step). `start`: node positions at the step's start (3n,
  /// m), which must outlive the stage. `scale`: factor 1 + damping share of the stiffness in the Hessian.
  /// `single`: whether single precision is sufficient.
  void begin_stage(const VecX& start, double scale, bool single);
  /// Returns whether this stage uses rotated elements: element data of the corotational law in single
  /// precision (corotated_elements.h).
  bool turned() const { return rotated_ && single_; }

  // ---- Rotated elements
  /// Computes the rotated elements (corotated_elements.h) and all other cached element data at node positions
  /// x (3n, m) in one pass. Does nothing if they are known at x.
  void linearise(const Eigen::Ref<const VecX>& x);
  /// Computes the stiffness matrix of the elements at node positions x (3n, m), from rotated elements, into
  /// `rows`.
  void assemble(const Eigen::Ref<const VecX>& x, SymmetricRows& rows);
  /// Returns whether this stage's last assembled matrix is still a good approximation. It is if no node is
  /// more than a tenth of a mesh cell from where it was then. `x`: node positions (3n, m). Returns false if
  /// no matrix was assembled in this stage.
  bool near_assembled(const Eigen::Ref<const VecX>& x) const;
  bool near_start(const Eigen::Ref<const VecX>& x) const;

  // ---- Damping: K at the stage's first evaluation point, which is x if there was none before.
  /// Returns ½uᵀKu, J, for node displacements u (3n, m). K is the warped stiffness (linear stiffness, rotated
  /// with each element) at the stage's first evaluation point, which is x if there was none before.
  double damping_energy(const Eigen::Ref<const VecX>& x, const VecX& u);
  /// Returns ½uᵀKu, J, for node displacements u (3n, m), and computes the forces f = K·u (3n, N). K is the
  /// warped stiffness at the stage's first evaluation point, which is x if there was none before.
  double damping_forces(const Eigen::Ref<const VecX>& x, const VecX& u, VecX& f);
  /// Returns the 3×3 blocks of the warped stiffness K (N/m) at the stage's first evaluation point, which is x
  /// if there was none before. Not for stages that use rotated elements.
  std::span<const Mat3> damping_blocks(const Eigen::Ref<const VecX>& x);

 private:
  /// Rotated elements (data of the corotational law, from which its stiffness is assembled), the node
  /// positions at which they were computed, and whether they are valid.
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

}  // namespace prosector::soft
