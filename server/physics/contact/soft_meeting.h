#pragma once
// Soft surfaces against each other: vertices against faces.

#include <vector>

#include "server/physics/collision/primitives/proximity.h"
#include "server/physics/collision/surface/triangle_surface.h"
#include "server/physics/contact/surface_detector.h"

namespace prosector {

/// A soft body's surface as others meet it, all at the same time.
struct SoftSkin {
  const SurfaceDetector* vertices = nullptr;
  const TriangleSurface* faces = nullptr;  // null: a rope has none
  double skin = 0;  // m, from the surface to where it is touched; 0: solid, with an inside
  double cell = 0;  // m, of its triangles, about
};

/// A vertex of one surface, and the point of another that it stops at.
struct VertexMeeting {
  std::uint32_t vertex = 0;
  SurfacePoint at;              // of the other surface
  Vec3 normal = Vec3::UnitY();  // unit, from the other surface to the vertex
  double gap = 0;               // m, < 0 penetrates
};

/// Depth in cells: what is farther inside is not looked for here (parting.h).
inline constexpr double deepest_meeting = 3;

/// Appends, in a fixed order, vertices of `from` whose gap to the faces of `to` is at most `margin`. There
/// are none unless `to` has an inside, which tells where they may not be. Vertices inside are found to a
/// depth of some cells; their way out is the shortest (Bærentzen and Aanæs 2005). Faces of `from` that look
/// another way than towards `to` don't stop it.
void find_meetings(const SoftSkin& from, const SoftSkin& to, double margin, std::vector<VertexMeeting>& out);

}  // namespace prosector
