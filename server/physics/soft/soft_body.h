#pragma once
// One deformable: mesh + model + integrator + LinearSolver, chosen per object by the rows of rungs.h.
//
// What the island solver needs of it is its incremental potential and the derivatives
//   E(x) = α/2·‖x − y‖²_M + W(x) + Σ_attach ½k‖x − x₀‖² + 1/(2·dxdv)·‖x − x_v‖²_C
// with C = damping_mass·M + damping_stiffness·K (Rayleigh; K: the attachments' and Hooke's stiffness, that
// turned with each element as it is where the stage's E was first asked for, so that C is constant while E is
// minimised; not the tangent there, which is without bound next to mirrored elements and would hold a ruined
// shape as it is) and α, y, x_v, dxdv as in time_integrator.h. Unknowns x: node positions, 3n, metres, room
// frame.

#include <memory>
#include <span>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/soft/base/mesh_edit.h"
#include "server/physics/soft/integrators/soft_state.h"
#include "server/physics/soft/laws/constitutive_law.h"
#include "server/physics/soft/solvers/linear_solver.h"
#include "server/physics/soft/unfold.h"
#include "server/physics/surface_edit.h"

namespace prosector {

class EdgeNodes;
class Substepper;

class SoftBody {
 public:
  /// `anatomy` is already in the room frame. Throws InputError for unknown rows, a mesh without a usable
  /// tetrahedron, indices or constants out of range. Degenerate tetrahedra are left out, their mass is not.
  SoftBody(const SoftDesc& desc, Anatomy anatomy);
  ~SoftBody();
  SoftBody(SoftBody&&) noexcept;

  // ---- Model: const while running
  const SoftDesc& desc() const;
  const Anatomy& anatomy() const;
  Eigen::Index nodes() const;
  const VecX& node_mass() const;  // n, kg, lumped ρV/4; positive (see least_mass_share)
  double total_mass() const;      // kg
  std::span<const double> surface_area()
      const;  // m², of each surface vertex at rest (a third of its triangles)
  /// With which it is minimised; of a body with a substepper, implicit Euler: for its equilibrium, and where
  /// its own method fails.
  const TimeIntegrator& integrator() const;
  /// Null for bodies that are minimised as they are.
  Substepper* substepper() const;
  std::size_t elements() const;              // that carry stress
  std::size_t dropped_elements() const;      // degenerate ones
  const VecX& attachment_stiffness() const;  // n, N/m, as described; 0: free
  std::uint64_t content_hash() const;        // connectivity, rest shape, masses: topology revision 0

  // ---- Following a cut, or what takes one back: between steps. Edits are those of the tetrahedra's
  // vertices; surfaces hang on these.
  /// Of quadratic elements: the nodes on edges, which follow the vertices; else null.
  const EdgeNodes* edge_nodes() const;
  /// The edit of all its nodes.
  MeshEdit edit_of_nodes(const MeshEdit& edit) const;
  /// Whether follow() will do, else it has to be made anew.
  bool can_follow(const MeshEdit& edit) const;
  /// As if made anew of its mesh so edited and of another surface, bit for bit, and under the same
  /// set_in_force(); what the edit leaves as it is is kept.
  void follow(const MeshEdit& edit, TriangleMesh surface, SparseMap embedding);
  /// Likewise, where the surface, too, is what it was but for an edit. It stays at its address.
  void follow(const MeshEdit& edit, const SurfaceEdit& surface);
  /// The same of a sheet, made of another geometry. `nodes`: which stay; `touched`: the corners there now,
  /// ascending, of cells and triangles that came or went.
  bool can_follow_sheet(const Kept& nodes) const;
  void follow_sheet(Anatomy sheet, const Kept& nodes, std::span<const std::uint32_t> touched);

  SoftBodyState initial_state() const;  // rest shape, at rest, asleep
  const VecX& rest() const;             // m, node positions of the rest shape

  // ---- What people made of it: between steps
  /// From here on its material is `stiffness` times as stiff as described, by damping too, and it is attached
  /// or not. Allocates when that changes.
  void set_in_force(double stiffness, bool attached);
  bool attached() const;  // whether something holds it now
  /// Whether gravity acts: on what was imaged under its weight (gravity = false) only once it is taken out of
  /// its place, or all that tied it there was cut off it, where nothing carries it any more.
  bool falls() const;

  // ---- One step. Caches (matrix, element batches) are members; nothing allocates after the constructor,
  // except Eigen's numeric factorisation within factor_solve.
  /// Starts a stage: α, y, x_v from the integrator. Where next asked about fixes the damping matrix.
  /// `euler`: by implicit Euler, whatever integrator() is, for all of the step.
  void begin_stage(int stage_index, double h, const Vec3& gravity, const SoftBodyState& state,
                   bool euler = false);
  const Stage& stage() const;
  /// Where Newton may start in the stage begun: x_n + h·v_n + warm_start, what constant acceleration would
  /// lead to; of a method of several stages, what constant velocity would.
  void initial_guess(double h, const SoftBodyState& state, Eigen::Ref<VecX> x) const;
  /// Finds what energy, gradient and Hessian need at x at once, where that is cheaper; for the Hessian only
  /// unless assemble_roughly() does without.
  void linearise(const Eigen::Ref<const VecX>& x);
  /// E(x), J. Not finite only for positions that are not, or so far away that it overflows.
  double energy(const Eigen::Ref<const VecX>& x);
  /// ∂E/∂x into `g` (3n, N).
  void gradient(const Eigen::Ref<const VecX>& x, Eigen::Ref<VecX> g);
  /// Assembles the (projected, SPD) Hessian at x for multiply, diagonal and factor_solve; its damping part,
  /// where the tangent is cheap, turned as the elements are at x.
  void assemble(const Eigen::Ref<const VecX>& x);
  /// As assemble(), but where no node has moved by more than a tenth of a cell, a matrix at hand serves: this
  /// stage's last one where the tangent is cheap; else, since the step's start, Hooke's stiffness turned with
  /// each element for the tangent, which damping has anyway. What that leaves out, the stress's own stiffness
  /// and the change of rotations, is small while strains are: good as a first Newton matrix. True then.
  bool assemble_roughly(const Eigen::Ref<const VecX>& x);
  /// Whether the tangent costs next to nothing: so it is where elements turn (turned_elements.h), in single
  /// precision, unless the solver is `direct` or inertia is less than 1e-5 of the stiffness.
  bool tangent_is_cheap() const;
  void multiply(const double* p, double* Hp) const;  // 3n each
  void diagonal(std::span<Mat3> blocks) const;       // n
  /// z = H⁻¹r by sparse Cholesky of the last assemble(), lazily factored; 3n each. Not for two threads at
  /// once on one body.
  void factor_solve(const double* r, double* z) const;
  /// z ≈ H⁻¹r by one multigrid V-cycle for the last assemble(), see multigrid.h. `diagonal` and `inverse`:
  /// the diagonal blocks with whatever touches the body, n each; unchanged until the next assemble(). Builds
  /// its coarse levels when the body is made with this solver, else at the first call.
  void multigrid_solve(std::span<const Mat3> diagonal, std::span<const Mat3> inverse, const double* r,
                       double* z) const;
  /// While true, steps are those of a body that has been held for ever, whatever its relaxation: for finding
  /// its equilibrium.
  void set_relaxed(bool relaxed);
  /// Keeps positions and velocities, to go back to.
  void remember(const SoftBodyState& state);
  /// Puts them back; nothing is known of the step before.
  void recall(SoftBodyState& state) const;
  const Motion& remembered() const;  // x and v
  /// Takes the minimiser into the state.
  void finish_stage(int stage_index, double h, const Eigen::Ref<const VecX>& x, SoftBodyState& state) const;

  /// Elastic + attachment energy at x, J, of what has relaxed (for reports; without inertia and damping).
  double elastic_energy(const Eigen::Ref<const VecX>& x);
  double kinetic_energy(const SoftBodyState& state) const;  // J
  /// The share of inertia, and of the weight that is in it, in the stage's E(x), J.
  double inertia_energy(const Eigen::Ref<const VecX>& x) const;
  /// What gravity gave on the way from one shape to another, J.
  double fall_energy(const VecX& from, const VecX& to, const Vec3& gravity) const;
  double diagonal() const;  // m, of the rest shape's bounding box
  /// Share of the rest volume that is inside out at x, or flat (below `least` of its own volume); 0 for
  /// sheets and ropes, which have no inside.
  double inverted_share(const VecX& x, double least = flat) const;
  /// Volume at x over that at rest, below 0 where it is inside out as a whole; 1 for sheets and ropes.
  double volume_share(const VecX& x) const;
  /// Its tetrahedra at rest, each quadratic one as eight; none of sheets and ropes.
  const TetMesh& linear_tets() const;
  /// The same nodes and attachments under the law that leads out of every shape, corotational, on linear
  /// tetrahedra (quadratic ones are eight each), which is made when first asked for; null for bodies that
  /// have it anyway, and for sheets and ropes.
  SoftBody* recovery();
  bool has_recovery() const;
  /// From here on recovery() is in force for good: under its own law the body's own weight crushes it. Asks
  /// for has_recovery(). Pieces of it are told, too.
  void keep_recovering();
  bool keeps_recovering() const;
  /// The body whose law is in force in this state: itself, or recovery().
  SoftBody& in_force(const SoftBodyState& state);
  /// Whether the body as a whole is turned by more than `angle` (rad) from its rest pose and its law is for
  /// small rotations; never of laws that turn along.
  bool turned_by(double angle, const VecX& x) const;
  /// Puts the rest shape where the body is: the rigid motion that fits best (Horn 1987), at its momentum and
  /// angular momentum; under a law for small rotations not turned and at its momentum only, since it would be
  /// taken for bent; a body that is attached, where it is attached, at rest. The way out of shapes that no
  /// force leads out of.
  void unfold(SoftBodyState& state) const;

  /// A node that no tetrahedron, or only flat ones, give a mass gets this share of the mean one: every
  /// unknown needs inertia.
  static constexpr double least_mass_share = 1e-6;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
