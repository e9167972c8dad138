#pragma once
// A deformable body: mesh, model, integrator and solver, selected per object from the tables of rungs.h.
//
// SoftBody owns the parts and gives access to the body's properties. Callers use the part they need:
//
//   step and island solver   potential(), stepper(); substepper() of explicit and position-based bodies
//   organs, after a cut      follower()
//   recovery after inversion recovery(), in_force(), unfold.h
//   reports and guards       mechanical_energy.h, potential().elastic_energy()
//
// Node positions are 3n, m, world frame.

#include <cstdint>
#include <memory>
#include <span>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/mechanics/soft/base/weight.h"
#include "server/physics/mechanics/soft/integrators/soft_state.h"

namespace prosector {

class ImplicitStepper;
class IncrementalPotential;
class MeshFollower;
class RecoveryLaw;
class Substepper;

class SoftBody {
 public:
  /// Creates a body from `anatomy`, which is in the world frame. Degenerate tetrahedra are left out, but not
  /// their mass. Throws InputError for unknown table rows, for a mesh without a usable tetrahedron, and for
  /// indices or constants out of range.
  SoftBody(const SoftDesc& desc, Anatomy anatomy);
  ~SoftBody();
  SoftBody(SoftBody&&) noexcept;

  // ---- Properties: constant during a session, except after cuts
  const SoftDesc& desc() const;
  const Anatomy& anatomy() const;
  Eigen::Index nodes() const;
  std::size_t elements() const;                  // elements that carry stress
  std::size_t dropped_elements() const;          // degenerate elements
  const VecX& rest() const;                      // 3n, m: node positions of the rest shape
  double diagonal() const;                       // m, of the rest shape's bounding box
  const VecX& node_mass() const;                 // n, kg, lumped ρV/4; positive
  double total_mass() const;                     // kg
  std::span<const double> surface_area() const;  // m², per surface vertex: a third of its triangles' area
  const VecX& attachment_stiffness() const;      // n, N/m, as described in the scene; 0: free
  /// Returns the body's tetrahedra in the rest shape, each quadratic one as eight linear ones; empty for
  /// sheets and ropes.
  const TetMesh& linear_tets() const;
  /// Returns whether the elastic forces rotate with the body (objectivity); false for laws of small
  /// rotations.
  bool objective() const;
  /// Returns a hash of connectivity, rest shape and masses.
  std::uint64_t content_hash() const;
  /// Returns the state of a sleeping body in its rest shape.
  SoftBodyState initial_state() const;

  // ---- Changes by users: between steps
  /// Multiplies the described stiffness, damping included, by `stiffness` and enables or disables the
  /// attachments. Allocates memory if a value changes.
  void set_in_force(double stiffness, bool attached);
  /// Returns whether an attachment holds the body at present.
  bool attached() const;
  /// Returns the body's weight under `gravity` (m/s²). A body that was imaged under its own weight (gravity =
  /// false) has no weight while it is supported. Its weight acts once it is taken out of its place, or once
  /// all its attachments were cut off.
  ///
  /// `borne`: whether something supports the body. Then quadratic elements distribute their weight by shape
  /// functions. A falling body distributes it by nodal masses, because shape functions would strain it.
  Weight weight(const Vec3& gravity, bool borne) const;

  // ---- Parts; const ones are for queries
  IncrementalPotential& potential();
  ImplicitStepper& stepper();
  const ImplicitStepper& stepper() const;
  /// Returns the substepper; null for bodies that are only minimised.
  Substepper* substepper() const;
  MeshFollower& follower();
  const MeshFollower& follower() const;
  RecoveryLaw& recovery();
  const RecoveryLaw& recovery() const;
  /// Returns the body whose law is in force in this state: this body or that of recovery().
  SoftBody& in_force(const SoftBodyState& state);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace prosector
