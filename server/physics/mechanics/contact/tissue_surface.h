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

namespace prosector {

/// Contact geometry of a soft body: spatial index, face tree, self-collision, thin-shell elements and proxy
/// shape.
class TissueSurface {
 public:
  /// Builds the spatial index of the vertices. `anatomy` outlives this and stays at its address.
  explicit TissueSurface(const Anatomy& anatomy);

  // ---- When the mesh is made or has changed
  /// Updates after an edit that the anatomy has taken in. `cut`: whether the mesh is numbered by a cut. Faces
  /// are updated only from one numbered mesh to another; otherwise they are rebuilt on demand.
  void follow(const SurfaceEdit& edit, bool cut);
  /// Rebuilds the spatial index after a change of the anatomy without an edit.
  void remake();
  /// Invalidates self-collision after the surface was re-embedded in other nodes. fit() and
  /// fit_self_collision() must follow.
  void rehang() { self_collision_.reset(); }
  /// Rebuilds the proxy shape, and invalidates elements and moved positions. Call before place().
  void fit(const SoftCollision& how, bool cut);
  /// Prepares self-collision of a solid. Returns false, and prepares nothing, if the surface is open.
  bool fit_self_collision(double cell);
  /// Sets whether contacts with other thin shells use thin-shell contact.
  void set_thin_shell(bool thin_shell) { thin_shell_ = thin_shell; }

  // ---- In a tick
  /// Marks faces and elements as outdated, so that they are moved on demand.
  void begin_tick() { faces_moved_ = elements_moved_ = false; }
  /// Moves vertices and proxy shape to the node positions `x` (3n, m).
  void place(const VecX& x);
  /// Moves the vertices only.
  void place_vertices(const VecX& x) { vertices_.update(x.data()); }

  const SurfaceDetector& vertices() const { return vertices_; }
  /// Returns the tree of faces in its current position, built at rest on first use; null: a rope has none.
  const TriangleSurface* faces();
  /// Returns the tree of faces, moved to the vertices once a tick.
  const TriangleSurface* moved_faces();
  /// Returns the thin-shell elements, moved to `x` once a tick.
  const ElementSurface& elements(const VecX& x);
  /// Returns the self-contact search; null: the body has none.
  SelfCollision* self_collision() { return self_collision_ ? &*self_collision_ : nullptr; }
  /// Returns the proxy shape with which the body collides; null: it collides as its mesh.
  const ProxyShape* proxy() const { return proxy_ ? &*proxy_ : nullptr; }
  bool thin_shell() const { return thin_shell_; }

 private:
  const Anatomy* anatomy_;
  SurfaceDetector vertices_;
  std::optional<TriangleSurface> faces_;
  std::optional<SelfCollision> self_collision_;
  std::optional<ElementSurface> elements_;
  std::optional<ProxyShape> proxy_;
  bool cut_ = false;  // the mesh is numbered, so the order of its triangles can be updated
  bool thin_shell_ = false;
  bool faces_moved_ = false, elements_moved_ = false;  // already moved in this tick
};

}  // namespace prosector
