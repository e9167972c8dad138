#pragma once
// Everything by which others meet a soft body's surface. All of it is a cache: the mesh and the nodes'
// positions decide it, whether it was made anew or followed a cut.

#include <optional>
#include <vector>

#include "server/physics/contact/element_surface.h"
#include "server/physics/contact/rough_shape.h"
#include "server/physics/contact/self_surface.h"
#include "server/physics/contact/soft_collision.h"
#include "server/physics/contact/soft_meeting.h"

namespace prosector {

class TissueSurface {
 public:
  /// Makes the vertices' tree of the surface. `anatomy` outlives this and stays at its address.
  explicit TissueSurface(const Anatomy& anatomy);

  // ---- When the mesh is made or has changed
  /// Follows an edit that the anatomy has taken in. `cut`: whether a cut numbers the mesh now. Faces follow
  /// only from one numbered mesh to another; otherwise they are made anew when asked for.
  void follow(const SurfaceEdit& edit, bool cut);
  /// Makes the vertices' tree anew, after a change of the anatomy that no edit tells of.
  void remake();
  /// Takes in that the surface hangs on other nodes. fit() and fit_self_collision() follow.
  void rehang() { self_collision_.reset(); }
  /// Makes the proxy shape anew, forgets elements at rest and where things were. Precedes place().
  void fit(const SoftCollision& how, bool cut);
  /// Prepares self-collision of a solid. Returns false, and prepares nothing, where the surface is open.
  bool fit_self_collision(double cell);
  /// Sets whether thin bodies that are so too meet this one as thin shells.
  void set_thin_shell(bool thin_shell) { thin_shell_ = thin_shell; }

  // ---- In a tick
  /// Lets faces and elements be moved anew when they are asked for.
  void begin_tick() { faces_moved_ = elements_moved_ = false; }
  /// Takes vertices and proxy to node positions `x` (3n, m).
  void place(const VecX& x);
  /// Takes the vertices there alone.
  void place_vertices(const VecX& x) { vertices_.update(x.data()); }

  const SurfaceDetector& vertices() const { return vertices_; }
  /// Returns the tree of faces as it is, made at rest when first asked for; null: a rope has none.
  const TriangleSurface* faces();
  /// Returns the tree of faces, taken to where the vertices are once a tick.
  const TriangleSurface* moved_faces();
  /// Returns the elements as others meet a thin shell's, taken to `x` once a tick.
  const ElementSurface& elements(const VecX& x);
  /// Returns what finds where a solid meets itself; null: it may not.
  SelfSurface* self_collision() { return self_collision_ ? &*self_collision_ : nullptr; }
  /// Returns the simple shape that the body collides as; null: it collides as its mesh.
  const RoughShape* proxy() const { return proxy_ ? &*proxy_ : nullptr; }
  bool thin_shell() const { return thin_shell_; }

 private:
  const Anatomy* anatomy_;
  SurfaceDetector vertices_;
  std::optional<TriangleSurface> faces_;
  std::optional<SelfSurface> self_collision_;
  std::optional<ElementSurface> elements_;
  std::optional<RoughShape> proxy_;
  bool cut_ = false;  // the mesh is numbered: the order of its triangles can follow
  bool thin_shell_ = false;
  bool faces_moved_ = false, elements_moved_ = false;  // in this tick
};

}  // namespace prosector
