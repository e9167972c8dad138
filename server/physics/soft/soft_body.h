#pragma once
// One deformable: mesh + ConstitutiveLaw + TimeIntegrator + LinearSolver, chosen per object.
//
// What the island solver needs of it is its incremental potential and the derivatives
//   E(x) = α/2·‖x − y‖²_M + W(x) + Σ_attach ½k‖x − x₀‖² + ½/h_d·‖x − x_n‖²_C
// with C = damping_mass·M + damping_stiffness·K(x_n) (Rayleigh). Unknowns x: node positions, 3n, metres, room
// frame.

#include <memory>
#include <span>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/soft/constitutive_law.h"
#include "server/physics/soft/linear_solver.h"
#include "server/physics/soft/time_integrator.h"

namespace prosector {

/// State of one soft body: everything that changes the next tick's bits.
struct SoftBodyState {
  Motion motion;
  VecX warm_start;  // 3n: last step's change of velocity·h, starts Newton
  bool asleep = true;
  int quiet_ticks = 0;
};

class SoftBody {
 public:
  /// `anatomy` is already in the room frame. Throws InputError for unknown rows, degenerate meshes, constants
  /// out of range.
  SoftBody(const SoftDesc& desc, Anatomy anatomy);
  ~SoftBody();
  SoftBody(SoftBody&&) noexcept;

  // ---- Model: const while running
  const SoftDesc& desc() const;
  const Anatomy& anatomy() const;
  Eigen::Index nodes() const;
  const VecX& node_mass() const;  // n, kg, lumped ρV/4
  double total_mass() const;      // kg
  std::span<const double> surface_area()
      const;  // m², of each surface vertex at rest (a third of its triangles)
  const TimeIntegrator& integrator() const;
  std::uint64_t content_hash() const;  // connectivity, rest shape, masses: topology revision 0

  SoftBodyState initial_state() const;  // rest shape, at rest, asleep

  // ---- One step. Caches (matrix, element batches) are members; nothing allocates after the constructor.
  /// Starts a stage: y and α from the integrator; `x_n` (state.motion.x) fixes the damping matrix.
  void begin_stage(int stage_index, double h, const Vec3& gravity, const SoftBodyState& state);
  /// E(x), J.
  double energy(const VecX& x);
  /// ∂E/∂x into `g` (3n, N).
  void gradient(const VecX& x, VecX& g);
  /// Assembles the (projected, SPD) Hessian at x for multiply, diagonal and factor.
  void assemble(const VecX& x);
  void multiply(const double* p, double* Hp) const;  // 3n each
  void diagonal(std::span<Mat3> blocks) const;       // n
  void factor_solve(const double* r,
                    double* z) const;  // z = H⁻¹r, sparse Cholesky of the last assemble(), lazily
  /// Takes the minimiser into the state.
  void finish_stage(int stage_index, double h, const VecX& x, SoftBodyState& state) const;

  /// Elastic + attachment energy at x, J (for reports; without inertia and damping).
  double elastic_energy(const VecX& x);
  double kinetic_energy(const SoftBodyState& state) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
