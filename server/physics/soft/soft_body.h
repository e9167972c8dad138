#pragma once
// One deformable: mesh, model, integrator and solver, chosen per object by the rows of rungs.h.
//
// SoftBody owns the parts and tells what the body is made of. Each caller takes the part that it works with:
//
//   step and island solver   potential(), stepper(); substepper() of explicit and position-based bodies
//   organs, after a cut      follower()
//   recovery of ruined ones  recovery(), in_force(), unfold.h
//   reports and guards       mechanical_energy.h, potential().elastic_energy()
//
// Node positions are 3n, m, world frame.

#include <cstdint>
#include <memory>
#include <span>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/soft/base/weight.h"
#include "server/physics/soft/integrators/soft_state.h"

namespace prosector {

class ImplicitStepper;
class IncrementalPotential;
class MeshFollower;
class RecoveryLaw;
class Substepper;

class SoftBody {
 public:
  /// Makes a body of `anatomy`, which is in the world frame. Leaves degenerate tetrahedra out, but not their
  /// mass. Throws InputError for unknown rows, a mesh without a usable tetrahedron, indices or constants out
  /// of range.
  SoftBody(const SoftDesc& desc, Anatomy anatomy);
  ~SoftBody();
  SoftBody(SoftBody&&) noexcept;

  // ---- What it is made of: const while running, but for cuts
  const SoftDesc& desc() const;
  const Anatomy& anatomy() const;
  Eigen::Index nodes() const;
  std::size_t elements() const;                  // that carry stress
  std::size_t dropped_elements() const;          // degenerate ones
  const VecX& rest() const;                      // 3n, m: node positions of the rest shape
  double diagonal() const;                       // m, of the rest shape's bounding box
  const VecX& node_mass() const;                 // n, kg, lumped ρV/4; positive
  double total_mass() const;                     // kg
  std::span<const double> surface_area() const;  // m², of each surface vertex: a third of its triangles
  const VecX& attachment_stiffness() const;      // n, N/m, as described; 0: free
  /// Returns its tetrahedra at rest, each quadratic one as eight linear ones; none of sheets and ropes.
  const TetMesh& linear_tets() const;
  /// Tells whether turning the whole body turns its forces along: not so under laws for small rotations.
  bool objective() const;
  /// Returns a hash of connectivity, rest shape and masses.
  std::uint64_t content_hash() const;
  /// Returns the state in which the body is at rest in its rest shape, asleep.
  SoftBodyState initial_state() const;

  // ---- What people made of it: between steps
  /// Makes its material `stiffness` times as stiff as described, by damping too, and ties it or not.
  /// Allocates when that changes.
  void set_in_force(double stiffness, bool attached);
  /// Tells whether something holds it now.
  bool attached() const;
  /// Returns what it weighs under `gravity` (m/s²). What was imaged under its weight (gravity = false) weighs
  /// nothing until nothing carries it any more. That is once the body is taken out of its place, or all that
  /// tied it there was cut off it. `borne`: whether something bears it. Then quadratic elements bear their
  /// weight by shape functions. What falls bears it by masses, or it would strain.
  Weight weight(const Vec3& gravity, bool borne) const;

  // ---- Its parts; const ones are for queries
  IncrementalPotential& potential();
  ImplicitStepper& stepper();
  const ImplicitStepper& stepper() const;
  /// Returns null for bodies that are minimised as they are.
  Substepper* substepper() const;
  MeshFollower& follower();
  const MeshFollower& follower() const;
  RecoveryLaw& recovery();
  const RecoveryLaw& recovery() const;
  /// Returns the body whose law is in force in this state: itself, or that of recovery().
  SoftBody& in_force(const SoftBodyState& state);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace prosector
