#pragma once
// Incremental potential of one soft body in a stage of an implicit step, without other bodies:
//   E(x) = α/2·‖x − y‖²_M + W(x) + Σ_attach ½k‖x − x₀‖² + 1/(2·dxdv)·‖x − x_v‖²_C
// with C = damping_mass·M + damping_stiffness·K, Rayleigh damping, and α, y, x_v, dxdv as in
// time_integrator.h. K is the stiffness of attachments plus the warped stiffness of the elements: the linear
// elastic stiffness, rotated with each element. The rotations are those at the stage's first evaluation of E,
// so C is constant during the minimisation. The tangent stiffness at that point is not suitable: it is
// unbounded next to mirrored elements and would lock an inverted shape in place.

#include <optional>
#include <span>

#include "server/physics/mechanics/soft/base/node_sum.h"
#include "server/physics/mechanics/soft/body_hessian.h"
#include "server/physics/mechanics/soft/integrators/time_integrator.h"
#include "server/physics/mechanics/soft/soft_matter.h"
#include "server/physics/mechanics/soft/stiffness_damping.h"

namespace prosector {

/// The unknowns x are node positions, 3n, m, world frame. Caches (matrix, element batches) are members. No
/// memory is allocated after construction, except by Eigen's numeric factorisation in factor_solve(). Not
/// thread-safe. Calls run in parallel internally, with bitwise equal results for any number of threads.
class IncrementalPotential {
 public:
  /// Throws InputError for an unknown solver. `matter` must outlive this object.
  explicit IncrementalPotential(const SoftMatter& matter);

  // ---- Stages, for ImplicitStepper
  /// Returns the data of the stage, which the integrator writes.
  Stage& stage() { return stage_; }
  const Stage& stage() const { return stage_; }
  /// Begins the stage described by stage(). `start`: 3n, m, positions at the step's start; must outlive the
  /// stage.
  void begin_stage(const VecX& start);

  // ---- E and its derivatives
  /// Computes the data that energy, gradient and Hessian need at x in one pass, if that is cheaper. Data for
  /// the Hessian are omitted if assemble_roughly() does not need them.
  void linearise(const Eigen::Ref<const VecX>& x);
  /// Returns E(x), J. Not finite only if positions are not finite or so large that E overflows.
  double energy(const Eigen::Ref<const VecX>& x);
  /// Writes ∂E/∂x into `g` (3n, N).
  void gradient(const Eigen::Ref<const VecX>& x, Eigen::Ref<VecX> g);
  /// Returns the inertial part of E(x), J, which includes the weight.
  double inertia_energy(const Eigen::Ref<const VecX>& x) const;
  /// Returns the elastic and attachment energy at x, J, after complete relaxation; without inertia and
  /// damping.
  double elastic_energy(const Eigen::Ref<const VecX>& x);

  // ---- The Hessian
  /// Assembles the Hessian at x, projected to be positive definite, for all calls below. If the tangent is
  /// cheap, the damping part uses the element rotations at x.
  void assemble(const Eigen::Ref<const VecX>& x);
  /// Assembles the Hessian, or uses an available matrix that still gives a descent direction; returns true
  /// then. If the tangent is cheap, that matrix is this stage's last one, else the warped stiffness at the
  /// step's start. Either is used if no node has moved by more than a tenth of a cell.
  bool assemble_roughly(const Eigen::Ref<const VecX>& x);
  /// Returns whether the tangent is cheap: in single precision for models with rotated elements
  /// (corotated_elements.h). Not cheap for solver `direct`, or if inertia is less than 1e-5 of the stiffness.
  bool tangent_is_cheap() const { return elements_.turned(); }
  void multiply(const double* p, double* Hp) const;  // 3n each
  void diagonal(std::span<Mat3> blocks) const;       // n
  /// Computes z = H⁻¹r by sparse Cholesky of the last assemble(), factored when first needed; 3n each.
  void factor_solve(const double* r, double* z);
  /// Computes z ≈ H⁻¹r by one multigrid V-cycle for the last assemble(), see multigrid.h. `diagonal` and
  /// `inverse`: n each, the diagonal blocks with contributions of everything that touches the body, unchanged
  /// until the next assemble(). The coarse levels are built with the body if the scene names this solver,
  /// else at the first call.
  void multigrid_solve(std::span<const Mat3> diagonal, std::span<const Mat3> inverse, const double* r,
                       double* z);

  // ---- When the matter changes, between steps
  /// Updates the potential after matter.weigh() changed the weights.
  void reweigh();
  /// Updates the potential after the matter followed a cut; equals a rebuild.
  void fit();

 private:
  StageWeights weights() const;
  void scale(double factor, double* vector) const;

  const SoftMatter& matter_;
  SoftSystem system_;
  StageElements elements_;
  StiffnessDamping damping_;
  std::optional<BodyHessian> hessian_;
  NodeSum node_sum_;
  Stage stage_;
};

}  // namespace prosector
