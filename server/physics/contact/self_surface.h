#pragma once
// A solid's surface against itself.

#include <utility>
#include <vector>

#include "server/physics/contact/soft_meeting.h"

namespace prosector {

/// A solid's surface as it meets itself. The shape at rest says which parts of it may meet. Those far from
/// each other may, but for the two sides of a wall; so may those that look at each other across a gap. Pairs
/// that are near are listed with room to spare. They are looked at until the surface may have moved by that
/// much (Verlet 1967, "Computer 'experiments' on classical fluids"). So a search where nothing is near costs
/// next to nothing. What it finds doesn't depend on when the list was made, or on how much of it at a time.
class SelfSurface {
 public:
  /// Takes a solid, whose surface is closed; it outlives this. `cell`: m, a mean_edge().
  SelfSurface(const Anatomy& anatomy, double cell);
  /// Follows a change after both took it in: finds from then on what a new one would. What the change didn't
  /// touch is moved or renumbered at most, and stays in the list.
  void follow(const SurfaceEdit& edit, const SurfaceDetector& vertices);

  /// Appends, ascending by vertex, those whose gap to another part of the surface is at most `margin`, or two
  /// cells if that is less, with the nearest point of it. Vertices inside are found to a depth of a cell, or
  /// half of a wall.
  void find(const SoftSkin& own, double margin, std::vector<VertexMeeting>& out);

 private:
  struct Face {      // at rest
    Vec3 middle;     // m
    Vec3 normal;     // unit
    double area;     // m²
    double pyramid;  // m³: from it to the origin
  };
  Face face(const std::array<std::uint32_t, 3>& corners) const;
  Vec3 outward(std::uint32_t vertex, const SurfaceDetector& vertices) const;
  void find_depth();
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // vertex, triangle
  bool may_meet(std::uint32_t vertex, std::uint32_t triangle) const;
  bool share_nodes(std::uint32_t vertex, std::uint32_t triangle) const;
  void place_new_ones(std::span<const Vec3> positions);
  /// Returns how much (m) any two points may have neared each other since the list was made.
  double neared(std::span<const Vec3> positions) const;
  void list(const SoftSkin& own, double reach);
  void list_vertex(const SoftSkin& own, std::uint32_t vertex, double reach, Pairs& out) const;
  void list_changed(const SoftSkin& own, double reach);
  void update_list(const SoftSkin& own, double reach);
  void forget_list();

  const Anatomy* anatomy_;
  double cell_;
  double deepest_ = 0;         // m, inside
  std::vector<Vec3> outward_;  // by vertex, unit, at rest
  std::vector<Face> faces_;
  Pairs near_;                   // ascending
  std::vector<Vec3> listed_at_;  // m, by vertex; empty: there is no list
  double reach_ = 0;             // m: what was nearer is in the list
  /// Marks of the last change, ascending, until the next search: vertices that came; what isn't in the list
  /// yet.
  std::vector<std::uint32_t> new_vertices_, changed_vertices_, changed_faces_;
};

/// Returns the mean edge (m) of a surface at rest.
double mean_edge(const TriangleMesh& surface);

}  // namespace prosector
