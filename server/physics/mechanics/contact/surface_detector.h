#pragma once
// Contact detection of soft surfaces with rigid bodies: which vertices and triangles are inside or near which
// body.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/collision/broad/collision_mask.h"
#include "server/physics/mechanics/collision/surface/space_order.h"
#include "server/physics/mechanics/collision/surface/vertex_stars.h"
#include "server/physics/mechanics/contact/contact.h"
#include "server/physics/mechanics/contact/part_boxes.h"
#include "server/physics/mechanics/contact/rod.h"
#include "server/physics/mechanics/contact/signed_distance.h"

namespace prosector::collision {
class RigidOutline;
}  // namespace prosector::collision

namespace prosector::contact {

/// Rigid body, hand or side of the room as seen by contact detection with soft bodies: pose, velocity, parts
/// and contact properties in the current tick.
struct Collider {
  std::size_t slot = 0;
  Pose pose;                                           // of the centre of mass, in the room frame
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  // m/s, rad/s
  const std::vector<collision::ShapePart>* parts = nullptr;
  const std::vector<std::unique_ptr<SignedDistance>>* distances = nullptr;
  std::vector<Pose> part_poses;               // current poses of the parts, which change as fingers bend
  double pull = 0;                            // m: bound of its displacement by other bodies within the tick
  Vec3 lo = Vec3::Zero(), hi = Vec3::Zero();  // m, bounding box
  double friction = 0;
  double rolling_resistance = 0;  // as RigidContactDesc::rolling_resistance
  bool fixed = false;
  std::optional<Pose> driven_to;  // fixed: pose at the tick's end
  collision::CollisionMask mask;
  bool continuous = false;  // contacts are found at the time of impact if the body is fast
  bool held_blade = false;  // its edge cuts and makes no contact
  const collision::RigidOutline* outline = nullptr;  // for bodies that collide as proxy shapes; null: none
};

/// Contact of a surface triangle with a thin part of a rigid body or with a corner of a box. The contact
/// point is inside the triangle or on an edge, not at a corner of the triangle.
struct TriangleTouch {
  std::uint32_t triangle = 0;
  Vec3 weights = Vec3::Zero();  // barycentric
  Vec3 point = Vec3::Zero();    // m, world frame
  Vec3 normal = Vec3::UnitY();  // unit, out of the rigid part
  double gap = 0;               // m, < 0 penetrates
  double strength = 1;          // in (0, 1]: share of the full contact stiffness, continuous in the positions
};

/// Function that returns, for a triangle of a sheet, the known unit direction out of the rigid part, or none
/// if it is unknown. A sheet has no inside that would determine on which side of it the part is.
using KnownSide = std::function<std::optional<Vec3>(std::uint32_t triangle)>;

/// Spatial index of one soft body's surface for contact detection. Vertices and triangles are sorted so that
/// neighbours are close to each other, and each run of them has a bounding box.
class SurfaceDetector {
 public:
  /// Builds the index from the surface at rest and its embedding in the simulation nodes. Keeps references to
  /// both, which must outlive this object. `two_sided`: whether the surface is that of a sheet, which has no
  /// inside.
  SurfaceDetector(const SparseMap& embedding, const TriangleMesh& rest, bool two_sided = false);
  /// Updates the index after an edit of the embedding and the surface to which this object refers. The result
  /// equals a newly constructed object before its first update(). Unchanged entries are only moved or
  /// renumbered.
  void follow(const SurfaceEdit& edit);

  /// Moves the surface to the node positions `x` (three coordinates per node, m) and refits the bounding
  /// boxes.
  void update(const double* x);
  const Vec3& lo() const { return lo_; }
  const Vec3& hi() const { return hi_; }
  std::span<const Vec3> positions() const { return positions_; }
  /// Returns the unit outward normal of the surface at a vertex: the area-weighted mean of the normals of its
  /// triangles. Returns zero if they cancel.
  Vec3 outward_at(std::uint32_t vertex) const;
  /// Returns the largest stretch (current length over rest length) among the edges of all triangles at the
  /// vertex.
  double stretch_at(std::uint32_t vertex) const;

  /// Calls f(vertex), in a fixed order, for each vertex inside the box from lo to hi (m, world frame).
  template <class F>
  void in_box(const Vec3& lo, const Vec3& hi, const F& f) const;
  /// Calls f(vertex, distance), in a fixed order, for each vertex whose signed distance to the collider's
  /// nearest part is at most `margin` (m). `distance` contains this distance and the part's normal.
  template <class F>
  void near(const Collider& collider, double margin, const F& f) const;
  /// Calls f(TriangleTouch), in a fixed order, for each triangle that a sphere, capsule or cylinder of the
  /// collider touches, up to `margin` (m) away. Only contacts inside a face or on an edge count: contacts at
  /// vertices alone would let such thin parts pass between the vertices. For each triangle, the deepest part
  /// is reported.
  ///
  /// A contact is reported only if it is clearly deeper than the triangle's corners and than `others`, the
  /// triangle's further contact points as barycentric weights. On a sheet, the contact is on the side given
  /// by `known`, or else on the nearer side.
  template <class F>
  void near_thin(const Collider& collider, double margin, const KnownSide& known,
                 std::span<const Vec3> others, const F& f) const;
  /// Calls f(triangle), in a fixed order, for each triangle whose bounding box overlaps the collider's
  /// bounding box, enlarged by `margin` (m) on all sides.
  template <class F>
  void near_triangles(const Collider& collider, double margin, const F& f) const;
  /// Returns the contact of a corner of one of the collider's boxes, at `at` (m, room frame), with the
  /// nearest face or edge of the surface. The corner must be at most `margin` (m) outside or `depth` (m)
  /// inside. Returns none unless the contact is clearly deeper than those of the face's corners and of
  /// `others`, the face's further contact points as barycentric weights. Contacts at these points alone would
  /// let the box's corner sink in.
  std::optional<TriangleTouch> near_corner(const Collider& collider, const Vec3& at, double margin,
                                           double depth, std::span<const Vec3> others) const;
  /// Returns the current positions of a triangle's corners, m, world frame.
  std::array<Vec3, 3> corners(std::uint32_t triangle) const;
  /// Returns the triangle's unit outward normal in its current position.
  Vec3 outward(std::uint32_t triangle) const;
  /// Returns the largest stretch (current length over rest length) of the triangle's three edges.
  double stretch(std::uint32_t triangle) const;
  /// Returns for each edge k (from corner k to k + 1) the index of the neighbouring triangle across it, or
  /// `triangle` itself if the edge is on a boundary.
  const std::array<std::uint32_t, 3>& neighbours(std::uint32_t triangle) const {
    return neighbours_[triangle];
  }
  /// Returns the indices of the triangles that have this vertex as a corner, ascending.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const { return stars_[vertex]; }
  /// Returns all triangle indices in the order of the spatial index, in which neighbours are close to each
  /// other.
  std::span<const std::uint32_t> triangle_order() const { return triangle_order_.order(); }
  /// Returns whether the collider touches the surface, or is at most `margin` (m) from it.
  bool touches(const Collider& collider, double margin) const;

 private:
  struct Chunk {
    Vec3 lo, hi;
  };
  struct TriangleChunk {
    Vec3 lo, hi;
    double longest;  // m²: squared longest edge of all its triangles
  };
  static constexpr std::size_t chunk_vertices = 32;
  std::size_t chunk_end(std::size_t chunk) const {
    return std::min(order_.size(), (chunk + 1) * chunk_vertices);
  }

  static constexpr std::size_t chunk_triangles = 64;
  std::size_t triangle_chunk_end(std::size_t chunk) const {
    return std::min(triangle_order_.size(), (chunk + 1) * chunk_triangles);
  }
  /// Calls f(chunk, vertices), in order, for each run of vertices (chunk) whose bounding box overlaps the box
  /// from lo to hi. `vertices` is a function: vertices(g) calls g(vertex) for each vertex of the run inside
  /// that box.
  template <class F>
  void in_chunks(const Vec3& lo, const Vec3& hi, const F& f) const;
  void fit_chunks();
  std::array<std::uint32_t, 3> neighbours_of(std::uint32_t triangle) const;
  /// Returns the radius (m) of the largest ball that passes between the corners of a right-angled triangle:
  /// half its longest edge. `longest`: square of the longest edge, m².
  static double gauge(double longest) { return std::sqrt(longest) / 2; }
  /// Returns the contact of a triangle with a thin part, given as a capsule. Returns none if they are more
  /// than `margin` (m) apart, or if a vertex, another triangle or a point of `others` reports the contact.
  std::optional<TriangleTouch> touch(std::uint32_t triangle, const Rod& rod, double margin,
                                     const KnownSide& known, std::span<const Vec3> others) const;

  const SparseMap* embedding_;
  const TriangleMesh* rest_;
  bool two_sided_;
  /// For each triangle and each edge k (from corner k to k + 1), the index of the neighbouring triangle
  /// across the edge. It is the triangle's own index if there is no neighbour.
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  collision::SpaceOrder triangle_order_;  // by centroid at rest
  std::vector<TriangleChunk> triangle_chunks_;
  std::vector<double> longest_;  // m²: squared longest edge of each triangle
  collision::VertexStars stars_;
  collision::SpaceOrder order_;  // of vertices, at rest
  std::vector<Vec3> positions_;  // by vertex
  std::vector<Chunk> chunks_;
  Vec3 lo_ = Vec3::Zero(), hi_ = Vec3::Zero();
};

/// Returns the signed distance from x (m, room frame) to the nearest part of the collider, with the part's
/// normal in the room frame. Parts farther than `margin` may be skipped: if all are, the returned value is
/// larger than the margin.
Distance distance_to(const Collider& collider, const Vec3& x, double margin);

/// Corner of a box-shaped part of a collider.
struct BoxCorner {
  std::uint32_t index = 0;  // 8 · part + corner
  Vec3 at = Vec3::Zero();   // m, world frame
  double depth = 0;         // m: the smallest half extent of the box
};
constexpr std::uint32_t corners_per_part = 8;

/// Calls f(BoxCorner) for each corner of the collider's box-shaped parts that is inside the box from lo to hi
/// (m, world frame) after that was enlarged by `margin` (m).
template <class F>
void box_corners(const Collider& collider, double margin, const Vec3& lo, const Vec3& hi, const F& f) {
  for (std::uint32_t i = 0; i < collider.parts->size(); ++i) {
    const collision::ShapePart& part = (*collider.parts)[i];
    if (part.kind != collision::ShapeKind::box) continue;
    const Pose pose = collider.pose * collider.part_poses[i];
    for (std::uint32_t k = 0; k < corners_per_part; ++k) {
      const Vec3 sign((k & 1U) != 0 ? 1 : -1, (k & 2U) != 0 ? 1 : -1, (k & 4U) != 0 ? 1 : -1);
      const Vec3 at = pose * Vec3(sign.cwiseProduct(part.half));
      if ((at.array() >= lo.array() - margin).all() && (at.array() <= hi.array() + margin).all())
        f(BoxCorner{corners_per_part * i + k, at, part.half.minCoeff()});
    }
  }
}

/// Returns the signed distance from x (m, room frame) to the nearest of those parts of the collider whose
/// indices are in `parts` (ascending). Parts farther than `margin` (m) may be skipped.
Distance distance_to(const Collider& collider, const Vec3& x, double margin,
                     std::span<const std::uint32_t> parts);

/// Returns the collider's spheres, capsules and cylinders as capsules in the room frame. Leaves out those
/// whose boxes, enlarged by `margin` (m), do not overlap the box from lo to hi.
std::vector<Rod> rods_of(const Collider& collider, double margin, const Vec3& lo, const Vec3& hi);

inline bool boxes_overlap(const Vec3& lo, const Vec3& hi, const Vec3& other_lo, const Vec3& other_hi) {
  return (lo.array() <= other_hi.array()).all() && (other_lo.array() <= hi.array()).all();
}

template <class F>
void SurfaceDetector::near_thin(const Collider& collider, double margin, const KnownSide& known,
                                std::span<const Vec3> others, const F& f) const {
  const Vec3 grow = Vec3::Constant(margin);
  if (!boxes_overlap(collider.lo - grow, collider.hi + grow, lo_, hi_)) return;
  const std::vector<Rod> rods = rods_of(collider, margin, lo_, hi_);
  if (rods.empty()) return;
  double thinnest = rods.front().radius;
  for (const Rod& rod : rods) thinnest = std::min(thinnest, rod.radius);
  for (std::size_t c = 0; c < triangle_chunks_.size(); ++c) {
    const TriangleChunk& chunk = triangle_chunks_[c];
    if (gauge(chunk.longest) <= thinnest) continue;  // vertex contacts suffice for all parts
    if (!boxes_overlap(collider.lo - grow, collider.hi + grow, chunk.lo, chunk.hi)) continue;
    for (std::size_t i = c * chunk_triangles; i < triangle_chunk_end(c); ++i) {
      if (gauge(longest_[triangle_order_[i]]) <= thinnest) continue;
      std::optional<TriangleTouch> deepest;
      for (const Rod& rod : rods)
        if (const auto found = touch(triangle_order_[i], rod, margin, known, others);
            found && (!deepest || found->gap < deepest->gap))
          deepest = found;
      if (deepest) f(*deepest);
    }
  }
}

template <class F>
void SurfaceDetector::near_triangles(const Collider& collider, double margin, const F& f) const {
  const Vec3 lo = collider.lo.array() - margin, hi = collider.hi.array() + margin;
  if (!boxes_overlap(lo, hi, lo_, hi_)) return;
  for (std::size_t c = 0; c < triangle_chunks_.size(); ++c) {
    if (!boxes_overlap(lo, hi, triangle_chunks_[c].lo, triangle_chunks_[c].hi)) continue;
    for (std::size_t i = c * chunk_triangles; i < triangle_chunk_end(c); ++i) {
      const auto x = corners(triangle_order_[i]);
      if (boxes_overlap(lo, hi, x[0].cwiseMin(x[1]).cwiseMin(x[2]), x[0].cwiseMax(x[1]).cwiseMax(x[2])))
        f(triangle_order_[i]);
    }
  }
}

template <class F>
void SurfaceDetector::in_chunks(const Vec3& lo, const Vec3& hi, const F& f) const {
  for (std::size_t c = 0; c < chunks_.size(); ++c) {
    if (!boxes_overlap(lo, hi, chunks_[c].lo, chunks_[c].hi)) continue;
    f(chunks_[c], [&](const auto& of_vertex) {
      for (std::size_t i = c * chunk_vertices; i < chunk_end(c); ++i) {
        const Vec3& x = positions_[order_[i]];
        if ((x.array() < lo.array()).any() || (x.array() > hi.array()).any()) continue;
        of_vertex(order_[i]);
      }
    });
  }
}

template <class F>
void SurfaceDetector::in_box(const Vec3& lo, const Vec3& hi, const F& f) const {
  if (!boxes_overlap(lo, hi, lo_, hi_)) return;
  in_chunks(lo, hi, [&](const Chunk&, const auto& vertices) { vertices(f); });
}

template <class F>
void SurfaceDetector::near(const Collider& collider, double margin, const F& f) const {
  const Vec3 lo = collider.lo.array() - margin, hi = collider.hi.array() + margin;
  if (!boxes_overlap(lo, hi, lo_, hi_)) return;
  PartBoxes parts(collider, margin);
  in_chunks(lo, hi, [&](const Chunk& chunk, const auto& vertices) {
    const std::vector<std::uint32_t>& met = parts.meeting(chunk.lo, chunk.hi);
    if (met.empty()) return;
    vertices([&](std::uint32_t vertex) {
      if (const Distance d = distance_to(collider, positions_[vertex], margin, met); d.value <= margin)
        f(vertex, d);
    });
  });
}

}  // namespace prosector::contact
