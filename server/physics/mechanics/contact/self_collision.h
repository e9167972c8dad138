#pragma once
// Contact of a solid's surface with itself.

#include <utility>
#include <vector>

#include "server/physics/mechanics/contact/soft_meeting.h"

namespace prosector::contact {

/// Search for contacts of a solid's surface with itself. The rest shape determines which parts may touch:
/// distant parts, except the two sides of a wall, and parts that face each other across a gap.
///
/// Near pairs of vertices and triangles are stored in a list with a spare distance. The list is reused until
/// the surface may have moved by that distance (Verlet 1967, "Computer 'experiments' on classical fluids").
/// So a search without near parts costs almost nothing. The result does not depend on when, or in how many
/// updates, the list was built.
class SelfCollision {
 public:
  /// Prepares the search for a solid with a closed surface. Keeps a pointer to `anatomy`, which must outlive
  /// this object. `cell`: mean edge length of the surface, m (see mean_edge()).
  SelfCollision(const Anatomy& anatomy, double cell);
  /// Updates the search after an edit of the surface, such as a cut, that the constructor's `anatomy` and
  /// `vertices` already contain. From then on find() returns what a newly constructed object would. Only
  /// renumbers stored pairs of a vertex and a near triangle that the edit left unchanged.
  void follow(const SurfaceEdit& edit, const SurfaceDetector& vertices);

  /// Appends, ascending, the vertices whose gap to another part of the surface is at most `margin` (m), with
  /// their nearest points there. The margin is limited to twice the mean edge length. Vertices inside the
  /// solid are found to a depth of one mean edge length, or half a wall thickness if that is less.
  void find(const SoftSkin& own, double margin, std::vector<VertexMeeting>& out);

 private:
  struct Face {      // of a triangle, at rest
    Vec3 middle;     // m
    Vec3 normal;     // unit
    double area;     // m²
    double pyramid;  // m³: signed volume of the pyramid from the triangle to the origin
  };
  Face face(const std::array<std::uint32_t, 3>& corners) const;
  Vec3 outward(std::uint32_t vertex, const SurfaceDetector& vertices) const;
  void find_depth();
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // vertex, triangle
  bool may_meet(std::uint32_t vertex, std::uint32_t triangle) const;
  bool share_nodes(std::uint32_t vertex, std::uint32_t triangle) const;
  void place_new_ones(std::span<const Vec3> positions);
  /// Returns an upper bound (m) of how much any two vertices have approached each other since the list of
  /// near pairs was built. `positions`: current vertex positions, m.
  double neared(std::span<const Vec3> positions) const;
  void list(const SoftSkin& own, double reach);
  void list_vertex(const SoftSkin& own, std::uint32_t vertex, double reach, Pairs& out) const;
  void list_changed(const SoftSkin& own, double reach);
  void update_list(const SoftSkin& own, double reach);
  void forget_list();

  const Anatomy* anatomy_;
  double cell_;
  double deepest_ = 0;         // m: search depth inside
  std::vector<Vec3> outward_;  // by vertex, unit, at rest
  std::vector<Face> faces_;
  Pairs near_;                   // candidate pairs, ascending
  std::vector<Vec3> listed_at_;  // m, by vertex: positions when the list was built; empty: no list
  double reach_ = 0;             // m: all pairs nearer than this are in the list
  /// New vertices of the last edit, and changed vertices and triangles whose pairs are not yet in the list of
  /// near pairs. Indices are ascending; the next search clears all three.
  std::vector<std::uint32_t> new_vertices_, changed_vertices_, changed_faces_;
};

/// Returns the mean edge length (m) of a surface at rest, taken over the edges of all triangles. Returns 0
/// for a surface without triangles, such as that of a rope.
double mean_edge(const TriangleMesh& surface);

}  // namespace prosector::contact
