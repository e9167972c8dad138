#pragma once
// Contact between soft surfaces: vertices against faces.

#include <vector>

#include "server/physics/mechanics/collision/primitives/proximity.h"
#include "server/physics/mechanics/collision/surface/triangle_surface.h"
#include "server/physics/mechanics/contact/surface_detector.h"

namespace prosector::contact {

/// Surface of a soft body in its current shape, for contact detection: the spatial index of its vertices, the
/// tree of its triangles, and their mean size.
struct SoftSkin {
  const SurfaceDetector* vertices = nullptr;
  const collision::TriangleSurface* faces = nullptr;  // null: a rope has no faces
  double skin = 0;  // m, from the simulated surface to the contact surface; 0: solid, with an inside
  double cell = 0;  // m: approximate edge length of its triangles
};

/// Contact of a surface vertex of one soft body with a point of another soft surface.
struct VertexMeeting {
  std::uint32_t vertex = 0;
  collision::SurfacePoint at;   // on the other surface
  Vec3 normal = Vec3::UnitY();  // unit, from the other surface to the vertex
  double gap = 0;               // m, < 0 penetrates
};

/// Largest depth to which find_meetings() finds vertices inside a solid, in mean edge lengths of its
/// triangles. Deeper vertices are handled by parting.h.
inline constexpr double deepest_meeting = 3;

/// Appends, in a fixed order, the vertices of `from` whose gap to the triangles of `to` is at most `margin`
/// (m). Appends none unless `to` is a solid with a closed surface. Vertices inside are found to a depth of
/// `deepest_meeting` mean edge lengths, and their normal is the shortest way out (Bærentzen and Aanæs 2005).
/// If `from` is a solid, a vertex outside is skipped if its own surface normal does not point towards `to`.
void find_meetings(const SoftSkin& from, const SoftSkin& to, double margin, std::vector<VertexMeeting>& out);

}  // namespace prosector::contact
