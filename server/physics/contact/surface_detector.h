#pragma once
// Soft surfaces against rigid bodies: which surface vertices are inside or near which body.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/collision/broad/collision_mask.h"
#include "server/physics/collision/surface/space_order.h"
#include "server/physics/collision/surface/vertex_stars.h"
#include "server/physics/contact/contact.h"
#include "server/physics/contact/part_boxes.h"
#include "server/physics/contact/rod.h"
#include "server/physics/contact/signed_distance.h"

namespace prosector {

class RigidOutline;

/// A rigid body, a hand or a side of the room as soft bodies meet it.
struct Collider {
  std::size_t slot = 0;
  Pose pose;                                           // centre of mass in the room
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  // m/s, rad/s
  const std::vector<ShapePart>* parts = nullptr;
  const std::vector<std::unique_ptr<SignedDistance>>* distances = nullptr;
  std::vector<Pose> part_poses;               // of the parts now: fingers bend
  double pull = 0;                            // m: how far something may pull it within the tick
  Vec3 lo = Vec3::Zero(), hi = Vec3::Zero();  // m, box around it
  double friction = 0;
  double rolling_resistance = 0;  // as of RigidDesc
  bool fixed = false;
  std::optional<Pose> driven_to;  // fixed: where it is when the tick ends
  CollisionMask mask;
  bool continuous = false;                // met at the time of impact, where it is fast
  bool held_blade = false;                // its edge cuts instead of touching
  const RigidOutline* outline = nullptr;  // for bodies that collide as simple shapes; null: it has none
};

/// A point of a surface triangle, off its corners, against a thin part or a part's corner.
struct TriangleTouch {
  std::uint32_t triangle = 0;
  Vec3 weights = Vec3::Zero();  // of the corners
  Vec3 point = Vec3::Zero();    // m, world frame
  Vec3 normal = Vec3::UnitY();  // unit, out of the rigid part
  double gap = 0;               // m, < 0 penetrates
  double strength = 1;          // in (0, 1]: share of the full contact stiffness, continuous in the positions
};

/// A function that returns which way is out of the rigid part, as far as is known, for a triangle of a sheet.
/// A sheet has no inside that could tell on which side of it a thing is.
using KnownSide = std::function<std::optional<Vec3>(std::uint32_t triangle)>;

/// One soft surface, in the order that keeps neighbours together, with boxes around runs of vertices.
class SurfaceDetector {
 public:
  /// Keeps references: both outlive this. `two_sided`: the surface is a sheet's, not a solid's.
  SurfaceDetector(const SparseMap& embedding, const TriangleMesh& rest, bool two_sided = false);
  /// Follows a change after both, which stay where they are, took it in: becomes what a new one would be
  /// before its first update. What the change didn't touch is moved or renumbered at most.
  void follow(const SurfaceEdit& edit);

  /// Takes the surface to node positions `x` (3n) and refits the boxes.
  void update(const double* x);
  const Vec3& lo() const { return lo_; }
  const Vec3& hi() const { return hi_; }
  std::span<const Vec3> positions() const { return positions_; }
  /// Returns the direction out of the tissue at the vertex, unit: its triangles' normals, weighed by their
  /// areas; zero: they cancel.
  Vec3 outward_at(std::uint32_t vertex) const;
  /// Returns the length of the most stretched edge of the faces around the vertex, over its length at rest.
  double stretch_at(std::uint32_t vertex) const;

  /// Calls back, in a fixed order, for every vertex inside the box.
  template <class F>
  void in_box(const Vec3& lo, const Vec3& hi, const F& f) const;
  /// Calls back, in a fixed order, for every vertex whose gap to the collider is at most `margin`: per vertex
  /// the closest part.
  template <class F>
  void near(const Collider& collider, double margin, const F& f) const;
  /// Calls back, in a fixed order, for what contacts at points alone would let slip between them. These are
  /// points inside faces and edges that come at most `margin` near a sphere, capsule or cylinder of the
  /// collider. They are clearly deeper than the face's corners, and than `others`: points of it, by their
  /// corners' weights, that are contacts too. Per triangle it is the deepest part. On a two-sided surface it
  /// is on the side that is known, else on the nearer one.
  template <class F>
  void near_thin(const Collider& collider, double margin, const KnownSide& known,
                 std::span<const Vec3> others, const F& f) const;
  /// Calls back, in a fixed order, for every triangle whose box, grown by `margin`, meets the collider's.
  template <class F>
  void near_triangles(const Collider& collider, double margin, const F& f) const;
  /// Returns where a corner of a box of the collider, `at` in the room, is nearest to a face or an edge: at
  /// most `margin` off or `depth` inside. It is clearly deeper than the face's corners and `others`, as
  /// above, are in the collider: what they alone would let sink between them.
  std::optional<TriangleTouch> near_corner(const Collider& collider, const Vec3& at, double margin,
                                           double depth, std::span<const Vec3> others) const;
  /// Returns the places of a triangle's corners, m.
  std::array<Vec3, 3> corners(std::uint32_t triangle) const;
  /// Returns the direction out of the tissue on the triangle, unit.
  Vec3 outward(std::uint32_t triangle) const;
  /// Returns the length of the triangle's most stretched edge over its length at rest.
  double stretch(std::uint32_t triangle) const;
  /// Returns the triangle across each of its edges, or itself.
  const std::array<std::uint32_t, 3>& neighbours(std::uint32_t triangle) const {
    return neighbours_[triangle];
  }
  /// Returns the triangles around a vertex, ascending.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const { return stars_[vertex]; }
  /// Returns triangles in the order in which they are looked at.
  std::span<const std::uint32_t> triangle_order() const { return triangle_order_.order(); }
  /// Tells whether anything is that near.
  bool touches(const Collider& collider, double margin) const;

 private:
  struct Chunk {
    Vec3 lo, hi;
  };
  struct TriangleChunk {
    Vec3 lo, hi;
    double longest;  // m², squared: the longest edge of all
  };
  static constexpr std::size_t chunk_vertices = 32;
  std::size_t chunk_end(std::size_t chunk) const {
    return std::min(order_.size(), (chunk + 1) * chunk_vertices);
  }

  static constexpr std::size_t chunk_triangles = 64;
  std::size_t triangle_chunk_end(std::size_t chunk) const {
    return std::min(triangle_order_.size(), (chunk + 1) * chunk_triangles);
  }
  /// Calls f(chunk, vertices) for each run of vertices that meets the box, in order; vertices(g) calls g for
  /// each of its vertices inside it.
  template <class F>
  void in_chunks(const Vec3& lo, const Vec3& hi, const F& f) const;
  void fit_chunks();
  std::array<std::uint32_t, 3> neighbours_of(std::uint32_t triangle) const;
  /// Returns the radius of the largest ball that passes between the corners of a right-angled triangle with
  /// that longest edge (m², squared), m.
  static double gauge(double longest) { return std::sqrt(longest) / 2; }
  /// Returns what of the triangle touches the rod, if that is for this triangle to say.
  std::optional<TriangleTouch> touch(std::uint32_t triangle, const Rod& rod, double margin,
                                     const KnownSide& known, std::span<const Vec3> others) const;

  const SparseMap* embedding_;
  const TriangleMesh* rest_;
  bool two_sided_;
  std::vector<std::array<std::uint32_t, 3>>
      neighbours_;             // per triangle and edge (k, k+1): across it, or itself
  SpaceOrder triangle_order_;  // by their middles at rest
  std::vector<TriangleChunk> triangle_chunks_;
  std::vector<double> longest_;  // m², squared: each triangle's longest edge
  VertexStars stars_;
  SpaceOrder order_;             // vertices, at rest
  std::vector<Vec3> positions_;  // by vertex
  std::vector<Chunk> chunks_;
  Vec3 lo_ = Vec3::Zero(), hi_ = Vec3::Zero();
};

/// Returns the nearest part of the collider at a point of the room; the normal is in the world frame. Parts
/// farther than `margin` may be skipped: the value is then larger than it.
Distance distance_to(const Collider& collider, const Vec3& x, double margin);

/// A corner of one of the collider's boxes.
struct BoxCorner {
  std::uint32_t index = 0;  // 8 times the part, plus the corner
  Vec3 at = Vec3::Zero();   // m, world frame
  double depth = 0;         // m: half the box's least extent
};
constexpr std::uint32_t corners_per_part = 8;

/// Calls back for each corner whose place, grown by `margin`, meets the box from lo to hi.
template <class F>
void box_corners(const Collider& collider, double margin, const Vec3& lo, const Vec3& hi, const F& f) {
  for (std::uint32_t i = 0; i < collider.parts->size(); ++i) {
    const ShapePart& part = (*collider.parts)[i];
    if (part.kind != ShapeKind::box) continue;
    const Pose pose = collider.pose * collider.part_poses[i];
    for (std::uint32_t k = 0; k < corners_per_part; ++k) {
      const Vec3 sign((k & 1U) != 0 ? 1 : -1, (k & 2U) != 0 ? 1 : -1, (k & 4U) != 0 ? 1 : -1);
      const Vec3 at = pose * Vec3(sign.cwiseProduct(part.half));
      if ((at.array() >= lo.array() - margin).all() && (at.array() <= hi.array() + margin).all())
        f(BoxCorner{corners_per_part * i + k, at, part.half.minCoeff()});
    }
  }
}

/// Returns the same of these parts alone, ascending.
Distance distance_to(const Collider& collider, const Vec3& x, double margin,
                     std::span<const std::uint32_t> parts);

/// Returns the collider's thin parts whose boxes, grown by `margin`, meet the given one.
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
    if (gauge(chunk.longest) <= thinnest) continue;  // corners stop them all
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

}  // namespace prosector
