#pragma once
// Contact between soft surfaces: vertices against faces.

#include <vector>

#include "server/physics/mechanics/collision/primitives/proximity.h"
#include "server/physics/mechanics/collision/surface/triangle_surface.h"
#include "server/physics/mechanics/contact/surface_detector.h"

namespace prosector {

/// A soft body's surface for contact, in one consistent pose.
struct SoftSkin {
  const SurfaceDetector* vertices = nullptr;
  const TriangleSurface* faces = nullptr;  // null: a rope has no faces
  double skin = 0;  // m, from the simulated surface to the contact surface; 0: solid, with an inside
  double cell = 0;  // m: approximate edge length of its triangles
};

/// Contact of a vertex of one surface with a point of another.
struct VertexMeeting {
  std::uint32_t vertex = 0;
  SurfacePoint at;              // on the other surface
  Vec3 normal = Vec3::UnitY();  // unit, from the other surface to the vertex
  double gap = 0;               // m, < 0 penetrates
};

/// Search depth in cells; deeper vertices are handled by parting.h.
inline constexpr double deepest_meeting = 3;

/// Appends, in a fixed order, the vertices of `from` whose gap to the faces of `to` is at most `margin`.
/// Finds none unless `to` has an inside. Vertices inside are found to a depth of some cells; their way out is
/// the shortest (Bærentzen and Aanæs 2005). Skips vertices outside whose own surface normal does not point
/// towards `to`.
void find_meetings(const SoftSkin& from, const SoftSkin& to, double margin, std::vector<VertexMeeting>& out);

}  // namespace prosector
