#pragma once
// Takes a soft body along with what cuts, and what takes them back, make of its mesh. Between steps only.
// See docs/decisions/0011-following-a-cut.md.

#include <memory>
#include <span>

#include "common/mesh.h"
#include "server/physics/soft/base/mesh_edit.h"
#include "server/physics/surface_edit.h"

namespace prosector {

class EdgeNodes;
class ImplicitStepper;
class IncrementalPotential;
class RecoveryLaw;
class Substepper;
struct SoftMatter;

/// The parts of a body, which all follow. `substepper` may be null.
struct FollowingParts {
  SoftMatter& matter;
  IncrementalPotential& potential;
  ImplicitStepper& stepper;
  RecoveryLaw& recovery;
  std::unique_ptr<Substepper>& substepper;
};

/// Edits are those of the tetrahedra's vertices: surfaces hang on these, and nodes on edges follow them.
class MeshFollower {
 public:
  /// Takes the parts, which must outlive this.
  explicit MeshFollower(const FollowingParts& parts) : parts_(parts) {}

  /// Returns the nodes on edges of a body of quadratic elements, else null.
  const EdgeNodes* edge_nodes() const;
  /// Returns the edit of all the body's nodes.
  MeshEdit edit_of_nodes(const MeshEdit& edit) const;

  /// Tells whether follow() will do, else the body has to be made anew.
  bool can_follow(const MeshEdit& edit) const;
  /// Makes the body as if made anew, bit for bit, of its mesh so edited, and of another surface. Keeps what
  /// the edit leaves as it is, and what SoftBody::set_in_force() set.
  void follow(const MeshEdit& edit, TriangleMesh surface, SparseMap embedding);
  /// Makes it so where the surface is what it was, but hangs on other nodes.
  void follow(const MeshEdit& edit, SparseMap embedding);
  /// Makes it so where the surface, too, is what it was but for an edit. The surface stays at its address.
  void follow(const MeshEdit& edit, const SurfaceEdit& surface);

  /// Tells whether follow_sheet() will do.
  bool can_follow_sheet(const Kept& nodes) const;
  /// Makes a sheet as if made anew of another geometry. `nodes`: which stay. `touched`: the corners there
  /// now, ascending, of cells and triangles that came or went.
  void follow_sheet(Anatomy sheet, const Kept& nodes, std::span<const std::uint32_t> touched);

 private:
  void follow_nodes(const MeshEdit& edit);
  void fit();

  FollowingParts parts_;
};

}  // namespace prosector
