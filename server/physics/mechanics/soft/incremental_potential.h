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

namespace prosector::soft {

/// Incremental potential E(x) of one soft body in one stage of an implicit step, with its gradient and
/// Hessian: inertia, elasticity, attachments and damping. The unknowns x are node positions (3n, m, world
/// frame). Caches are members, so calls are not thread-safe. Calls run in parallel internally, with bitwise
/// equal results for any number of threads. No memory is allocated after construction, except by the numeric
/// factorisation in factor_solve().
class IncrementalPotential {
 public:
  /// Initialises the potential for a body's mesh, elements and masses. Throws InputError if the linear solver
  /// that the scene names does not exist. `matter` must outlive this object.
  explicit IncrementalPotential(const SoftMatter& matter);

  // ---- Stages, for ImplicitStepper
  /// Returns the data of the current stage (one minimisation of an implicit step), into which the integrator
  /// writes α, y, x_v and dxdv.
  Stage& stage() { return stage_; }
  const Stage& stage() const { return stage_; }
  /// Begins the stage (one minimisation of an implicit step) whose data are in stage(). `start`: node
  /// positions at the step's start (3n, m), which must outlive the stage.
  void begin_stage(const VecX& start);

  // ---- E and its derivatives
  /// Computes the element data that energy, gradient and Hessian at node positions x (3n, m) share in one
  /// pass, if the elements support that. Skips the elements if x is so close to the last assembly that
  /// assemble_roughly() would reuse its matrix.
  void linearise(const Eigen::Ref<const VecX>& x);
  /// Returns the incremental potential E (J) at node positions x (3n, m). It is finite unless positions are
  /// not finite or so large that E overflows.
  double energy(const Eigen::Ref<const VecX>& x);
  /// Writes the gradient of the incremental potential at node positions x (3n, m) into `g` (3n, N).
  void gradient(const Eigen::Ref<const VecX>& x, Eigen::Ref<VecX> g);
  /// Returns the inertial part of the incremental potential, α/2·‖x − y‖²_M, in J, at node positions x (3n,
  /// m). It includes gravity, which is part of y.
  double inertia_energy(const Eigen::Ref<const VecX>& x) const;
  /// Returns the energy (J) stored in elements and attachments at node positions x (3n, m), without inertia
  /// and damping. Viscoelastic stress counts as completely relaxed.
  double elastic_energy(const Eigen::Ref<const VecX>& x);

  // ---- The Hessian
  /// Computes the Hessian of the incremental potential at node positions x (3n, m), projected to be positive
  /// definite. The products and solves below use it. If tangent_is_cheap(), its damping part uses the element
  /// rotations at x instead of those at the stage's first evaluation.
  void assemble(const Eigen::Ref<const VecX>& x);
  /// Computes the Hessian at node positions x (3n, m), or uses a cheaper matrix that still gives a descent
  /// direction; returns true in the latter case. If tangent_is_cheap(), that is this stage's last Hessian.
  /// Otherwise it has the warped stiffness (linear stiffness rotated with each element) instead of the
  /// tangent. A cheaper matrix is used if no node moved by more than a tenth of a mesh cell since it was
  /// valid.
  bool assemble_roughly(const Eigen::Ref<const VecX>& x);
  /// Returns whether the Hessian is computed from rotated elements (corotated_elements.h) in single
  /// precision, at a fraction of the usual cost. False for other models, for solver `direct`, and if inertia
  /// is less than 1e-5 of the stiffness.
  bool tangent_is_cheap() const { return elements_.turned(); }
  void multiply(const double* p, double* Hp) const;  // 3n each
  void diagonal(std::span<Mat3> blocks) const;       // n
  /// Computes z = H⁻¹·r (3n each) by sparse Cholesky factorisation of the Hessian H of the last assemble(). H
  /// is factored at the first call after it.
  void factor_solve(const double* r, double* z);
  /// Computes z ≈ H⁻¹·r (3n each) by one multigrid V-cycle for the Hessian H of the last assemble(), see
  /// multigrid.h. `diagonal`: H's n diagonal blocks, including the stiffness of all contacts and ties of the
  /// body; `inverse`: their inverses. Both must stay unchanged until the next assemble(). The coarse levels
  /// are built with the body if the scene names this solver, otherwise at the first call.
  void multigrid_solve(std::span<const Mat3> diagonal, std::span<const Mat3> inverse, const double* r,
                       double* z);

  // ---- When the matter changes, between steps
  /// Updates the potential after SoftMatter::weigh() changed the body's stiffness factor or its attachments.
  void reweigh();
  /// Updates the potential after a cut changed the body's mesh: resizes arrays and discards cached data. The
  /// result equals that of a newly built object.
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

}  // namespace prosector::soft
