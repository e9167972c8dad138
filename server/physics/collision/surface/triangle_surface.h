#pragma once
// A surface of triangles that can be asked for distances: rigid in its own frame, or soft and moving.

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/collision/primitives/closest_points.h"
#include "server/physics/collision/surface/surface_topology.h"
#include "server/physics/collision/surface/surface_tree.h"

namespace prosector {

struct NearestPoint {
  std::uint32_t triangle = 0;
  Vec3 weights = Vec3::Zero();  // of its corners
  Vec3 point = Vec3::Zero();    // m
  double distance = 0;          // m
};

/// move() takes a soft surface to new positions and refits its tree. A cut makes a new topology: construct
/// the surface anew with it, O(n log n). Do so from rest positions where the tree itself shall not depend on
/// when (its answers don't). Or let one whose tree is that of an order follow.
class TriangleSurface {
 public:
  using Corners = SurfaceTopology::Corners;
  /// Throws InputError for no triangles, numbers that aren't finite, and what SurfaceTopology refuses.
  explicit TriangleSurface(const TriangleMesh& mesh);
  TriangleSurface(std::shared_ptr<const SurfaceTopology> topology, std::vector<Vec3> positions);
  /// Builds the surface with the tree of an order of the triangles (surface_tree.h).
  TriangleSurface(const TriangleMesh& mesh, std::span<const std::uint32_t> order);
  /// Follows a change to what the constructor from an order would make of the mesh after it.
  void follow(const SurfaceEdit& edit, const TriangleMesh& mesh, std::span<const std::uint32_t> order);

  /// Moves the vertices. Returns false, and moves nothing, when a number isn't finite. Throws InputError for
  /// a wrong count.
  bool move(std::span<const Vec3> positions);

  const SurfaceTopology& topology() const { return *topology_; }
  std::span<const Vec3> positions() const { return positions_; }
  const SurfaceTree& tree() const { return tree_; }
  const Aabb& box() const { return tree_.box(); }
  Triangle triangle(std::uint32_t t) const {
    const Corners& c = topology_->triangles()[t];
    return {positions_[c[0]], positions_[c[1]], positions_[c[2]]};
  }

  /// Returns the closest point of the surface; nothing farther away than `limit`. Of equally close triangles
  /// the first counts.
  std::optional<NearestPoint> nearest(const Vec3& x,
                                      double limit = std::numeric_limits<double>::infinity()) const;
  /// Returns the unit normal at a point of the surface: of the face, or the angle-weighted pseudonormal of
  /// its edge or corner (Bærentzen and Aanæs 2005). Its sign tells inside from outside. It is zero where all
  /// is degenerate.
  Vec3 normal_at(std::uint32_t triangle, const Vec3& weights) const;
  /// Tells whether x, whose closest point that is, lies inside; never inside an open surface.
  bool is_inside(const Vec3& x, const NearestPoint& nearest) const;
  /// Returns how often a closed surface winds around x: 1 inside, 0 outside. It also tells of one that is
  /// folded through itself, where the nearest point tells nothing (Jacobson et al. 2013, "Robust
  /// inside-outside segmentation using generalized winding numbers"). O(log triangles) for a closed surface;
  /// O(triangles) for an open one, and where the ray along +x meets an edge.
  double winding_number(const Vec3& x) const;
  /// Returns the vertex that lies farthest that way, the first of equals.
  std::uint32_t farthest(const Vec3& direction) const;

 private:
  std::optional<int> crossings(const Vec3& x) const;
  Vec3 face_normal(std::uint32_t triangle) const;

  std::shared_ptr<const SurfaceTopology> topology_;
  std::vector<Vec3> positions_;
  SurfaceTree tree_;
};

}  // namespace prosector
