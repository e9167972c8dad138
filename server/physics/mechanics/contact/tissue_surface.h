#pragma once
// All contact geometry of a soft body. It is a cache: mesh and node positions determine it, whether it was
// rebuilt or updated after a cut.

#include <optional>
#include <vector>

#include "server/physics/mechanics/contact/element_surface.h"
#include "server/physics/mechanics/contact/proxy_shape.h"
#include "server/physics/mechanics/contact/self_collision.h"
#include "server/physics/mechanics/contact/soft_collision.h"
#include "server/physics/mechanics/contact/soft_meeting.h"

namespace prosector::contact {

/// Contact geometry of a soft body: the spatial index of its surface, the tree of its triangles, the search
/// for self-contact, the elements of thin bodies, and the proxy shape.
class TissueSurface {
 public:
  /// Builds the spatial index of the soft body's surface. Keeps a pointer to `anatomy`, which must outlive
  /// this object and stay at its address.
  explicit TissueSurface(const Anatomy& anatomy);

  // ---- When the mesh is made or has changed
  /// Updates the contact geometry after an edit of the surface, such as a cut, that the anatomy already
  /// contains. `cut`: whether the mesh has the numbering of a cut mesh, whose triangle order can be updated.
  /// The tree of triangles and the self-contact search are updated if it had this numbering before, too;
  /// otherwise they are discarded.
  void follow(const SurfaceEdit& edit, bool cut);
  /// Rebuilds the spatial index, and discards the tree of triangles and the self-contact search. To be called
  /// if the anatomy changed in another way than by a known edit.
  void remake();
  /// Discards the self-contact search after the surface was embedded in other simulation nodes. The caller
  /// must call fit() and fit_self_collision() afterwards.
  void rehang() { self_collision_.reset(); }
  /// Rebuilds the proxy shape for these collision settings, and marks the elements of thin bodies and the
  /// moved triangles as outdated. Must be called before place(). `cut`: whether the mesh has the numbering of
  /// a cut mesh.
  void fit(const SoftCollision& how, bool cut);
  /// Prepares the self-contact search of a solid. `cell`: mean edge length of its surface, m. Returns false,
  /// and discards the search, if the surface is not closed.
  bool fit_self_collision(double cell);
  /// Sets whether the body's contacts with other thin bodies are found by thin-shell contact (layers.h).
  void set_thin_shell(bool thin_shell) { thin_shell_ = thin_shell; }

  // ---- In a tick
  /// Marks the triangles and the elements of thin bodies as not yet moved in this tick, so that they are
  /// moved on first use.
  void begin_tick() { faces_moved_ = elements_moved_ = false; }
  /// Moves the surface vertices and the proxy shape to the node positions `x` (three coordinates per node,
  /// m).
  void place(const VecX& x);
  /// Moves the surface vertices to the node positions `x` (three coordinates per node, m), but not the proxy
  /// shape.
  void place_vertices(const VecX& x) { vertices_.update(x.data()); }

  const SurfaceDetector& vertices() const { return vertices_; }
  /// Returns the tree of surface triangles in the position to which it was last moved. It is built at rest on
  /// first use. Returns null for a rope, which has no triangles.
  const collision::TriangleSurface* faces();
  /// Returns the tree of surface triangles, moved to the current vertices once per tick; null for a rope,
  /// which has no triangles.
  const collision::TriangleSurface* moved_faces();
  /// Returns the elements (triangles or segments) of a sheet or rope, moved to the node positions `x` (m)
  /// once per tick.
  const ElementSurface& elements(const VecX& x);
  /// Returns the search for contacts of the body's surface with itself; null if the body has none.
  SelfCollision* self_collision() { return self_collision_ ? &*self_collision_ : nullptr; }
  /// Returns the proxy shape that replaces the body in contact detection; null if the body collides as its
  /// mesh.
  const ProxyShape* proxy() const { return proxy_ ? &*proxy_ : nullptr; }
  bool thin_shell() const { return thin_shell_; }

 private:
  const Anatomy* anatomy_;
  SurfaceDetector vertices_;
  std::optional<collision::TriangleSurface> faces_;
  std::optional<SelfCollision> self_collision_;
  std::optional<ElementSurface> elements_;
  std::optional<ProxyShape> proxy_;
  bool cut_ = false;  // the mesh is numbered, so the order of its triangles can be updated
  bool thin_shell_ = false;
  bool faces_moved_ = false, elements_moved_ = false;  // already moved in this tick
};

}  // namespace prosector::contact
