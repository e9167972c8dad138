#include <LinearMath/btConvexHullComputer.h>

#include "server/physics/mechanics/collision/shapes/shape.h"

namespace prosector::collision {

TriangleMesh convex_hull(const std::vector<Vec3>& points) {
  std::vector<btVector3> in;
  in.reserve(points.size());
  for (const Vec3& p : points)
    in.emplace_back(static_cast<btScalar>(p.x()), static_cast<btScalar>(p.y()), static_cast<btScalar>(p.z()));
  btConvexHullComputer hull;
  hull.compute(&in.data()->m_floats[0], static_cast<int>(sizeof(btVector3)), static_cast<int>(in.size()), 0,
               0);
  TriangleMesh out;
  for (int i = 0; i < hull.vertices.size(); ++i) {
    const btVector3& v = hull.vertices[i];
    out.positions.emplace_back(static_cast<double>(v.x()), static_cast<double>(v.y()),
                               static_cast<double>(v.z()));
  }
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

}  // namespace prosector::collision
