#pragma once
// Updates a soft body after a cut, or after a cut was undone, changed its mesh. Call between steps only. See
// docs/decisions/0011-following-a-cut.md.

#include <memory>
#include <span>

#include "common/mesh.h"
#include "server/physics/base/surface_edit.h"
#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector {

class EdgeNodes;
class ImplicitStepper;
class IncrementalPotential;
class RecoveryLaw;
class Substepper;
struct SoftMatter;

/// The parts of a body that are updated together. `substepper` may be null.
struct FollowingParts {
  SoftMatter& matter;
  IncrementalPotential& potential;
  ImplicitStepper& stepper;
  RecoveryLaw& recovery;
  std::unique_ptr<Substepper>& substepper;
};

/// Updates a soft body after edits of its mesh. Edits describe the vertices of the tetrahedra: surfaces are
/// embedded in vertices, and edge nodes follow from vertices.
class MeshFollower {
 public:
  /// Takes the parts, which must outlive this object.
  explicit MeshFollower(const FollowingParts& parts) : parts_(parts) {}

  /// Returns the edge nodes of a body of quadratic elements, else null.
  const EdgeNodes* edge_nodes() const;
  /// Extends an edit of the vertices to all nodes of the body.
  MeshEdit edit_of_nodes(const MeshEdit& edit) const;

  /// Returns whether follow() can apply the edit; if not, the body must be rebuilt.
  bool can_follow(const MeshEdit& edit) const;
  /// Updates the body to the edited mesh and a new surface. Bitwise equal to a rebuild. Keeps unchanged data
  /// and the values of SoftBody::set_in_force().
  void follow(const MeshEdit& edit, TriangleMesh surface, SparseMap embedding);
  /// Updates the body as above if the surface is unchanged but embedded in other nodes.
  void follow(const MeshEdit& edit, SparseMap embedding);
  /// Updates the body as above and applies an edit to the surface, which keeps its address.
  void follow(const MeshEdit& edit, const SurfaceEdit& surface);

  /// Returns whether follow_sheet() can apply the edit.
  bool can_follow_sheet(const Kept& nodes) const;
  /// Updates a sheet to another geometry; equals a rebuild. `nodes`: the nodes that are kept. `touched`: the
  /// present corners, ascending, of cells and triangles that were added or removed.
  void follow_sheet(Anatomy sheet, const Kept& nodes, std::span<const std::uint32_t> touched);

 private:
  void follow_nodes(const MeshEdit& edit);
  void fit();

  FollowingParts parts_;
};

}  // namespace prosector
