#pragma once
// What a stage of an implicit step minimises for one soft body, without the bodies around it:
//   E(x) = α/2·‖x − y‖²_M + W(x) + Σ_attach ½k‖x − x₀‖² + 1/(2·dxdv)·‖x − x_v‖²_C
// with C = damping_mass·M + damping_stiffness·K, Rayleigh damping, and α, y, x_v, dxdv as in
// time_integrator.h. K is the attachments' and Hooke's stiffness. It is turned with each element as it is
// where the stage's E was first asked for, so that C is constant while E is minimised. The tangent there
// would not do: it is without bound next to mirrored elements and would hold a ruined shape as it is.

#include <optional>
#include <span>

#include "server/physics/soft/base/node_sum.h"
#include "server/physics/soft/body_hessian.h"
#include "server/physics/soft/integrators/time_integrator.h"
#include "server/physics/soft/soft_matter.h"
#include "server/physics/soft/stiffness_damping.h"

namespace prosector {

/// Unknowns x are node positions, 3n, m, world frame. Caches (matrix, element batches) are members. Nothing
/// allocates after the constructor, except Eigen's numeric factorisation within factor_solve(). Not for
/// several threads at once; inside it runs in parallel, with the same bits for any number of threads.
class IncrementalPotential {
 public:
  /// Throws InputError for an unknown solver. `matter` must outlive this.
  explicit IncrementalPotential(const SoftMatter& matter);

  // ---- Stages, for ImplicitStepper
  /// Gives access to what a stage is about, which the integrator writes.
  Stage& stage() { return stage_; }
  const Stage& stage() const { return stage_; }
  /// Begins the stage that stands in stage(). `start`: 3n, m, the step's start; must outlive the stage.
  void begin_stage(const VecX& start);

  // ---- E and its derivatives
  /// Finds what energy, gradient and Hessian need at x at once, where that is cheaper; for the Hessian only
  /// unless assemble_roughly() does without.
  void linearise(const Eigen::Ref<const VecX>& x);
  /// Returns E(x), J. Not finite only for positions that are not, or so far away that it overflows.
  double energy(const Eigen::Ref<const VecX>& x);
  /// Writes ∂E/∂x into `g` (3n, N).
  void gradient(const Eigen::Ref<const VecX>& x, Eigen::Ref<VecX> g);
  /// Returns the share of inertia, and of the weight that is in it, in E(x), J.
  double inertia_energy(const Eigen::Ref<const VecX>& x) const;
  /// Returns the elastic and attachment energy at x, J, of what has relaxed: without inertia and damping.
  double elastic_energy(const Eigen::Ref<const VecX>& x);

  // ---- The Hessian
  /// Assembles the Hessian at x, projected so that it is positive definite, for all calls below. Where the
  /// tangent is cheap, its damping part is turned as the elements are at x.
  void assemble(const Eigen::Ref<const VecX>& x);
  /// Assembles it, or takes a matrix at hand that is good to descend with: true then. Where the tangent is
  /// cheap, that is this stage's last one; else Hooke's stiffness turned with each element as at the step's
  /// start. It serves where no node has moved by more than a tenth of a cell.
  bool assemble_roughly(const Eigen::Ref<const VecX>& x);
  /// Tells whether the tangent costs next to nothing: where elements turn (turned_elements.h), in single
  /// precision. Not so under the solver `direct`, or where inertia is less than 1e-5 of the stiffness.
  bool tangent_is_cheap() const { return elements_.turned(); }
  void multiply(const double* p, double* Hp) const;  // 3n each
  void diagonal(std::span<Mat3> blocks) const;       // n
  /// Finds z = H⁻¹r by sparse Cholesky of the last assemble(), factored when first asked for; 3n each.
  void factor_solve(const double* r, double* z);
  /// Finds z ≈ H⁻¹r by one multigrid V-cycle for the last assemble(), see multigrid.h. `diagonal` and
  /// `inverse`: n each, the diagonal blocks with whatever touches the body, the same until the next
  /// assemble(). Builds its coarse levels with the body if the scene names this solver, else when first
  /// called.
  void multigrid_solve(std::span<const Mat3> diagonal, std::span<const Mat3> inverse, const double* r,
                       double* z);

  // ---- When the matter changes, between steps
  /// Takes in that matter.weigh() found other weights.
  void reweigh();
  /// Takes in that the matter followed a cut, as if made anew.
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
