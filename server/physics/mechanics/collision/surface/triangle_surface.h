#pragma once
// Triangle surface with distance queries: rigid in its own frame, or soft and moving.

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/collision/primitives/closest_points.h"
#include "server/physics/mechanics/collision/surface/surface_topology.h"
#include "server/physics/mechanics/collision/surface/surface_tree.h"

namespace prosector::collision {

struct NearestPoint {
  std::uint32_t triangle = 0;
  Vec3 weights = Vec3::Zero();  // barycentric, of the triangle's corners
  Vec3 point = Vec3::Zero();    // m
  double distance = 0;          // m
};

/// Triangle surface with distance queries, accelerated by a bounding volume hierarchy. move() moves the
/// vertices and updates the hierarchy's boxes. After a cut, construct a new surface, O(n log n), or call
/// follow() on a surface that was constructed with an order of its triangles. If the hierarchy must not
/// depend on when the cut is made, construct from rest positions; query results never depend on it.
class TriangleSurface {
 public:
  using Corners = SurfaceTopology::Corners;
  /// Builds the surface and its hierarchy. Throws InputError for a mesh without triangles, for positions that
  /// are not finite, and for a triangle with an invalid or repeated vertex.
  explicit TriangleSurface(const TriangleMesh& mesh);
  TriangleSurface(std::shared_ptr<const SurfaceTopology> topology, std::vector<Vec3> positions);
  /// Builds the surface with a hierarchy from a given order of the triangle indices, in which neighbours are
  /// close to each other (space_order.h).
  TriangleSurface(const TriangleMesh& mesh, std::span<const std::uint32_t> order);
  /// Updates the surface after an edit such as a cut. The result equals a surface constructed from `mesh`
  /// (the surface after the edit) and `order` (its triangle indices, neighbours close to each other).
  void follow(const SurfaceEdit& edit, const TriangleMesh& mesh, std::span<const std::uint32_t> order);

  /// Replaces all vertex positions, m, and updates the hierarchy's boxes. Returns false, and moves nothing,
  /// if a coordinate is not finite. Throws InputError if the number of positions is not the number of
  /// vertices.
  bool move(std::span<const Vec3> positions);

  const SurfaceTopology& topology() const { return *topology_; }
  std::span<const Vec3> positions() const { return positions_; }
  const SurfaceTree& tree() const { return tree_; }
  const Aabb& box() const { return tree_.box(); }
  Triangle triangle(std::uint32_t t) const {
    const Corners& c = topology_->triangles()[t];
    return {positions_[c[0]], positions_[c[1]], positions_[c[2]]};
  }

  /// Returns the point of the surface closest to x; nothing if it is farther away than `limit`, m. Of equally
  /// close triangles, it uses the one with the lowest index.
  std::optional<NearestPoint> nearest(const Vec3& x,
                                      double limit = std::numeric_limits<double>::infinity()) const;
  /// Returns the outward unit normal at the point with these barycentric weights on a triangle. It is the
  /// face normal inside the triangle, and the angle-weighted pseudonormal on an edge or at a corner
  /// (Bærentzen and Aanæs 2005). For a closest point, the sign of its dot product with the offset separates
  /// inside from outside. The normal is zero if all adjacent triangles are degenerate.
  Vec3 normal_at(std::uint32_t triangle, const Vec3& weights) const;
  /// Returns whether x is inside the closed surface; always false for an open surface. `nearest`: the point
  /// of the surface closest to x, as returned by nearest().
  bool is_inside(const Vec3& x, const NearestPoint& nearest) const;
  /// Returns the winding number of the surface around x: for a closed surface, 1 inside and 0 outside. It is
  /// also valid for a surface that intersects itself, for which the closest point does not determine the
  /// side. Source: Jacobson et al. 2013, "Robust inside-outside segmentation using generalized winding
  /// numbers". The cost is O(log triangles) for a closed surface. It is O(triangles) for an open surface, and
  /// where the ray from x along +x meets an edge.
  double winding_number(const Vec3& x) const;
  /// Returns the index of the vertex farthest along `direction`; of equally far vertices, the lowest index.
  std::uint32_t farthest(const Vec3& direction) const;

 private:
  std::optional<int> crossings(const Vec3& x) const;
  Vec3 face_normal(std::uint32_t triangle) const;

  std::shared_ptr<const SurfaceTopology> topology_;
  std::vector<Vec3> positions_;
  SurfaceTree tree_;
};

}  // namespace prosector::collision
