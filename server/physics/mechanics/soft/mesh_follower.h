#pragma once
// Updates a soft body after a cut, or after a cut was undone, changed its mesh. Call between steps only. See
// docs/decisions/0011-following-a-cut.md.

#include <memory>
#include <span>

#include "common/mesh.h"
#include "server/physics/base/surface_edit.h"
#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector::soft {

class EdgeNodes;
class ImplicitStepper;
class IncrementalPotential;
class RecoveryLaw;
class Substepper;
struct SoftMatter;

/// Parts of a soft body that must be updated together after a cut changed its mesh: mesh and masses,
/// potential, steppers and recovery law. `substepper` may be null.
struct FollowingParts {
  SoftMatter& matter;
  IncrementalPotential& potential;
  ImplicitStepper& stepper;
  RecoveryLaw& recovery;
  std::unique_ptr<Substepper>& substepper;
};

/// Updates all parts of a soft body after its mesh was edited by a cut or an undo. Edits describe the
/// vertices of the tetrahedra only. Surfaces are embedded in vertices, and the edge nodes of quadratic
/// elements follow from vertices.
class MeshFollower {
 public:
  /// Stores references to the parts of the soft body that follow() updates. They must outlive this object.
  explicit MeshFollower(const FollowingParts& parts) : parts_(parts) {}

  /// Returns the edge nodes (mid-edge nodes) of the body's quadratic elements; null for a body of other
  /// elements.
  const EdgeNodes* edge_nodes() const;
  /// Returns the mesh edit for all nodes of the body, given its edit of the vertices: adds the new, moved and
  /// removed edge nodes of quadratic elements. For other elements it returns `edit` unchanged.
  MeshEdit edit_of_nodes(const MeshEdit& edit) const;

  /// Returns whether follow() can apply the mesh edit to the body. If not, for example because an element is
  /// degenerate or the body is not of tetrahedra, the body must be rebuilt.
  bool can_follow(const MeshEdit& edit) const;
  /// Updates the body to the mesh after `edit`, with a new surface and its embedding in the vertices. The
  /// result is bitwise equal to a rebuild. Unchanged data and the values of SoftBody::set_in_force() are
  /// preserved.
  void follow(const MeshEdit& edit, TriangleMesh surface, SparseMap embedding);
  /// Updates the body to the mesh after `edit` when its surface triangles did not change but are now embedded
  /// as in `embedding`. The result is bitwise equal to a rebuild.
  void follow(const MeshEdit& edit, SparseMap embedding);
  /// Updates the body to the mesh after `edit` and applies the edit `surface` to its surface in place. The
  /// result is bitwise equal to a rebuild.
  void follow(const MeshEdit& edit, const SurfaceEdit& surface);

  /// Returns whether follow_sheet() can apply an edit to the body: it is a sheet with `nodes.before` nodes
  /// whose model supports it. If not, the body must be rebuilt.
  bool can_follow_sheet(const Kept& nodes) const;
  /// Updates a sheet to its geometry `sheet` after a cut or an undo; the result equals a rebuild. `nodes`:
  /// which nodes remained, and their new indices. `touched`: ascending indices, after the change, of the
  /// corners of cells and triangles that were added or removed.
  void follow_sheet(Anatomy sheet, const Kept& nodes, std::span<const std::uint32_t> touched);

 private:
  void follow_nodes(const MeshEdit& edit);
  void fit();

  FollowingParts parts_;
};

}  // namespace prosector::soft
