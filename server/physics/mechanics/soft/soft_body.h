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

namespace prosector::soft {

class ImplicitStepper;
class IncrementalPotential;
class MeshFollower;
class RecoveryLaw;
class Substepper;

class SoftBody {
 public:
  /// Creates a body from its description and `anatomy`, its mesh and surface in the world frame. Degenerate
  /// tetrahedra are left out of the elements, but their mass is counted. Throws InputError for an unknown
  /// model, integrator or solver, for a mesh without a usable element, and for indices or constants out of
  /// range.
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
  /// Returns the body's mesh of linear tetrahedra in the rest shape. For quadratic elements, each is divided
  /// into eight. Empty for sheets and ropes.
  const TetMesh& linear_tets() const;
  /// Returns whether the body's elastic model is objective: rotating the body causes no strain. False for
  /// linear elasticity, which is valid for small rotations only.
  bool objective() const;
  /// Returns a hash of the body's mesh connectivity, rest positions and nodal masses, for comparing two
  /// bodies.
  std::uint64_t content_hash() const;
  /// Returns the initial state of the body: in its rest shape, without velocity and stress history, and
  /// asleep.
  SoftBodyState initial_state() const;

  // ---- Changes by users: between steps
  /// Sets the factor `stiffness` on the body's described stiffness and damping, and enables or disables its
  /// attachments to the room. Allocates memory if a value changes.
  void set_in_force(double stiffness, bool attached);
  /// Returns whether an enabled attachment currently holds some node of the body in the room.
  bool attached() const;
  /// Returns the weight of the body's nodes under `gravity` (m/s²). A body that was imaged under its own
  /// weight (scene field `gravity = false`) has no weight until its attachments are disabled or all of them
  /// are cut off.
  ///
  /// `borne`: whether something supports the body. If so, quadratic elements distribute their weight to nodes
  /// by shape functions. A falling body distributes it by nodal masses, because shape functions would strain
  /// it.
  Weight weight(const Vec3& gravity, bool borne) const;

  // ---- Parts; const ones are for queries
  IncrementalPotential& potential();
  ImplicitStepper& stepper();
  const ImplicitStepper& stepper() const;
  /// Returns the integrator that advances the body in explicit or position-based substeps. Null for bodies
  /// that are stepped only by implicit minimisation.
  Substepper* substepper() const;
  MeshFollower& follower();
  const MeshFollower& follower() const;
  RecoveryLaw& recovery();
  const RecoveryLaw& recovery() const;
  /// Returns the body by which a step must advance `state`: the copy under the recovery law while
  /// `state.recovering` is true, otherwise this body.
  SoftBody& in_force(const SoftBodyState& state);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace prosector::soft
