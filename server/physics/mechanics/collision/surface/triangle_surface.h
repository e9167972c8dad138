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

namespace prosector {

struct NearestPoint {
  std::uint32_t triangle = 0;
  Vec3 weights = Vec3::Zero();  // barycentric, of the triangle's corners
  Vec3 point = Vec3::Zero();    // m
  double distance = 0;          // m
};

/// Triangle surface with a bounding volume hierarchy. move() moves the vertices and refits the tree. A cut
/// changes the topology: construct a new surface, O(n log n), or call follow() on a surface built from an
/// order. Construct from rest positions if the tree must not depend on the time of the cut; query results
/// never do.
class TriangleSurface {
 public:
  using Corners = SurfaceTopology::Corners;
  /// Throws InputError for an empty surface, for numbers that are not finite, and for an invalid topology.
  explicit TriangleSurface(const TriangleMesh& mesh);
  TriangleSurface(std::shared_ptr<const SurfaceTopology> topology, std::vector<Vec3> positions);
  /// Builds the surface with a tree from an order of the triangles (surface_tree.h).
  TriangleSurface(const TriangleMesh& mesh, std::span<const std::uint32_t> order);
  /// Updates the surface after an edit; equals a rebuild by the constructor that takes an order.
  void follow(const SurfaceEdit& edit, const TriangleMesh& mesh, std::span<const std::uint32_t> order);

  /// Moves the vertices. Returns false, and moves nothing, if a number is not finite. Throws InputError for a
  /// wrong number of positions.
  bool move(std::span<const Vec3> positions);

  const SurfaceTopology& topology() const { return *topology_; }
  std::span<const Vec3> positions() const { return positions_; }
  const SurfaceTree& tree() const { return tree_; }
  const Aabb& box() const { return tree_.box(); }
  Triangle triangle(std::uint32_t t) const {
    const Corners& c = topology_->triangles()[t];
    return {positions_[c[0]], positions_[c[1]], positions_[c[2]]};
  }

  /// Returns the closest point of the surface; nothing if it is farther away than `limit`. Of equally close
  /// triangles, the one with the lowest index is returned.
  std::optional<NearestPoint> nearest(const Vec3& x,
                                      double limit = std::numeric_limits<double>::infinity()) const;
  /// Returns the unit normal at a point of the surface: the face normal, or the angle-weighted pseudonormal
  /// of the edge or corner (Bærentzen and Aanæs 2005). Its sign separates inside from outside. The normal is
  /// zero if all adjacent triangles are degenerate.
  Vec3 normal_at(std::uint32_t triangle, const Vec3& weights) const;
  /// Returns whether x is inside the surface; false for an open surface. `nearest`: the closest point to x.
  bool is_inside(const Vec3& x, const NearestPoint& nearest) const;
  /// Returns the winding number of the surface around x; for a closed surface 1 inside, 0 outside. Also valid
  /// for a surface that intersects itself, for which the closest point does not determine the side. Source:
  /// Jacobson et al. 2013, "Robust inside-outside segmentation using generalized winding numbers". The cost
  /// is O(log triangles) for a closed surface. It is O(triangles) for an open one, and where the ray along +x
  /// meets an edge.
  double winding_number(const Vec3& x) const;
  /// Returns the vertex farthest in a direction; of equals, the one with the lowest index.
  std::uint32_t farthest(const Vec3& direction) const;

 private:
  std::optional<int> crossings(const Vec3& x) const;
  Vec3 face_normal(std::uint32_t triangle) const;

  std::shared_ptr<const SurfaceTopology> topology_;
  std::vector<Vec3> positions_;
  SurfaceTree tree_;
};

}  // namespace prosector
