#include <LinearMath/btConvexHullComputer.h>

#include "server/physics/collision/shape.h"
#include "server/physics/rigid/bullet_types.h"

namespace prosector {

TriangleMesh convex_hull(const std::vector<Vec3>& points) {
  std::vector<btVector3> in;
  in.reserve(points.size());
  for (const Vec3& p : points) in.push_back(to_bullet(p));
  btConvexHullComputer hull;
  hull.compute(&in.data()->m_floats[0], static_cast<int>(sizeof(btVector3)), static_cast<int>(in.size()), 0,
               0);
  TriangleMesh out;
  for (int i = 0; i < hull.vertices.size(); ++i) out.positions.push_back(from_bullet(hull.vertices[i]));
  for (int f = 0; f < hull.faces.size(); ++f) {
    const btConvexHullComputer::Edge* first = &hull.edges[hull.faces[f]];
    const btConvexHullComputer::Edge* edge = first->getNextEdgeOfFace();
    const auto corner = static_cast<std::uint32_t>(first->getSourceVertex());
    for (; edge->getTargetVertex() != first->getSourceVertex(); edge = edge->getNextEdgeOfFace())
      out.triangles.push_back({corner, static_cast<std::uint32_t>(edge->getSourceVertex()),
                               static_cast<std::uint32_t>(edge->getTargetVertex())});
  }
  return out;
}

}  // namespace prosector
