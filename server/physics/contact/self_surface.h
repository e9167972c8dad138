#pragma once
// A solid's surface against itself.

#include <utility>
#include <vector>

#include "server/physics/contact/soft_meeting.h"

namespace prosector {

/// Which parts of a surface may meet, the shape at rest says: those far from each other, but for the two
/// sides of a wall, and those that look at each other across a gap. Pairs that are near are listed with room
/// to spare and looked at until the surface may have moved by that much (Verlet 1967, "Computer 'experiments'
/// on classical fluids"), so a search where nothing is near costs next to nothing, and what it finds doesn't
/// depend on when the list was made.
class SelfSurface {
 public:
  /// A solid's, whose surface is closed; it outlives this.
  explicit SelfSurface(const Anatomy& anatomy);

  /// Appends, ascending by vertex, those whose gap to another part of the surface is at most `margin`, or two
  /// cells if that is less, with the nearest point of it. Vertices inside are found to a depth of a cell, or
  /// half of a wall.
  void find(const SoftSkin& own, double margin, std::vector<VertexMeeting>& out);

 private:
  bool may_meet(std::uint32_t vertex, std::uint32_t triangle) const;
  bool share_nodes(std::uint32_t vertex, std::uint32_t triangle) const;
  /// m: how much any two points may have neared each other since the list was made.
  double neared(std::span<const Vec3> positions) const;
  void list(const SoftSkin& own, double reach);

  const Anatomy* anatomy_;
  double cell_;                                                // m, mean edge of the triangles
  double deepest_;                                             // m, inside
  std::vector<Vec3> outward_;                                  // by vertex, unit, at rest
  std::vector<Vec3> middles_, normals_;                        // by triangle, at rest: m; unit
  std::vector<std::pair<std::uint32_t, std::uint32_t>> near_;  // vertex, triangle; ascending
  std::vector<Vec3> listed_at_;                                // m, by vertex
  double reach_ = 0;                                           // m: what was nearer is in the list
};

}  // namespace prosector
