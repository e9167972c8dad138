#include "server/physics/mechanics/contact/surface_detector.h"

#include <algorithm>
#include <array>
#include <limits>

#include "common/assert.h"
#include "server/physics/base/parallel.h"

namespace prosector::contact {
namespace {

constexpr std::size_t triangles_at_once = 1024;

Vec3 middle(const std::vector<Vec3>& positions, const std::array<std::uint32_t, 3>& t) {
  return (positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3;
}

std::vector<Vec3> middles(const std::vector<Vec3>& positions,
                          std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<Vec3> out;
  out.reserve(triangles.size());
  for (const auto& t : triangles) out.push_back(middle(positions, t));
  return out;
}

// By how much (in radii) a triangle's point must be deeper than its corners to get a contact, and to get full
// strength. Parts that are broad relative to the mesh stay below: vertex contacts carry them.
constexpr double least_between = 0.3, fully_between = 0.5;
// Radii: spare room between the corners from which a contact has full strength.
constexpr double full_room = 0.2;
// Depth relative to the vertices, in edge lengths, at which a corner contact has full strength.
constexpr double fully_beside = 0.1;
constexpr double least_apart = 1e-9;  // m: at smaller distances a direction is dominated by rounding
constexpr double most_depth = 2;      // radii: deeper points beyond the surface get no contact

}  // namespace

SurfaceDetector::SurfaceDetector(const SparseMap& embedding, const TriangleMesh& rest, bool two_sided)
    : embedding_(&embedding),
      rest_(&rest),
      two_sided_(two_sided),
      neighbours_(rest.triangles.size()),
      stars_(rest.triangles, rest.positions.size()) {
  parallel_both([&] { triangle_order_ = collision::SpaceOrder(middles(rest.positions, rest.triangles)); },
                [&] { order_ = collision::SpaceOrder(rest.positions); });
  parallel_chunks(neighbours_.size(), triangles_at_once,
                  [&](std::size_t first, std::size_t last, std::size_t) {
                    for (std::size_t i = first; i < last; ++i)
                      neighbours_[i] = neighbours_of(static_cast<std::uint32_t>(i));
                  });
  fit_chunks();
}

void SurfaceDetector::follow(const SurfaceEdit& edit) {
  stars_.follow(edit);
  order_.follow(edit.vertices, edit.positions);
  triangle_order_.follow(edit.triangles, middles(rest_->positions, edit.corners));
  for (auto& across : neighbours_)
    for (std::uint32_t& triangle : across) triangle = edit.triangles.now[triangle];
  // New entries are found below, like the neighbours of removed triangles.
  apply(edit.triangles, edit.corners, neighbours_);
  for (const std::uint32_t triangle : stars_.around(edit.touched))
    neighbours_[triangle] = neighbours_of(triangle);
  fit_chunks();
}

void SurfaceDetector::fit_chunks() {
  PROSECTOR_ASSERT(order_.size() == rest_->positions.size() && stars_.vertices() == rest_->positions.size());
  PROSECTOR_ASSERT(triangle_order_.size() == rest_->triangles.size() &&
                   neighbours_.size() == rest_->triangles.size());
  positions_ = rest_->positions;
  chunks_.resize((order_.size() + chunk_vertices - 1) / chunk_vertices);
  triangle_chunks_.resize((triangle_order_.size() + chunk_triangles - 1) / chunk_triangles);
  longest_.resize(triangle_order_.size());
}

std::array<std::uint32_t, 3> SurfaceDetector::neighbours_of(std::uint32_t triangle) const {
  const auto& corners = rest_->triangles[triangle];
  std::array<std::uint32_t, 3> out = {triangle, triangle, triangle};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t from = corners[(k + 1) % 3], to = corners[k];
    for (const std::uint32_t other : stars_[from]) {
      const auto& t = rest_->triangles[other];
      const std::uint32_t after_from = t[0] == from ? t[1] : t[1] == from ? t[2] : t[0];
      if (after_from == to) out[k] = other;
    }
  }
  return out;
}

void SurfaceDetector::update(const double* x) {
  lo_ = Vec3::Constant(std::numeric_limits<double>::max());
  hi_ = -lo_;
  for (std::size_t c = 0; c < chunks_.size(); ++c) {
    Vec3 lo = Vec3::Constant(std::numeric_limits<double>::max()), hi = -lo;
    for (std::size_t i = c * chunk_vertices; i < chunk_end(c); ++i) {
      const Vec3 p = positions_[order_[i]] = embedding_->apply(order_[i], x);
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
    chunks_[c] = {lo, hi};
    lo_ = lo_.cwiseMin(lo);
    hi_ = hi_.cwiseMax(hi);
  }
  for (std::size_t c = 0; c < triangle_chunks_.size(); ++c) {
    Vec3 lo = Vec3::Constant(std::numeric_limits<double>::max()), hi = -lo;
    double longest = 0;
    for (std::size_t i = c * chunk_triangles; i < triangle_chunk_end(c); ++i) {
      const auto x = corners(triangle_order_[i]);
      for (const Vec3& corner : x) {
        lo = lo.cwiseMin(corner);
        hi = hi.cwiseMax(corner);
      }
      const double own = longest_[triangle_order_[i]] =
          std::max({(x[1] - x[0]).squaredNorm(), (x[2] - x[1]).squaredNorm(), (x[0] - x[2]).squaredNorm()});
      longest = std::max(longest, own);
    }
    triangle_chunks_[c] = {lo, hi, longest};
  }
}

std::array<Vec3, 3> SurfaceDetector::corners(std::uint32_t triangle) const {
  const auto& t = rest_->triangles[triangle];
  return {positions_[t[0]], positions_[t[1]], positions_[t[2]]};
}

Vec3 SurfaceDetector::outward(std::uint32_t triangle) const {
  const auto x = corners(triangle);
  return (x[1] - x[0]).cross(x[2] - x[0]).normalized();
}

double SurfaceDetector::stretch(std::uint32_t triangle) const {
  const auto& t = rest_->triangles[triangle];
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t a = t[k], b = t[(k + 1) % 3];
    const double now = (positions_[a] - positions_[b]).squaredNorm();
    most = std::max(most, now / (rest_->positions[a] - rest_->positions[b]).squaredNorm());
  }
  return std::sqrt(most);
}

Vec3 SurfaceDetector::outward_at(std::uint32_t vertex) const {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t triangle : stars_[vertex]) {
    const auto x = corners(triangle);
    sum += (x[1] - x[0]).cross(x[2] - x[0]);
  }
  return sum.normalized();
}

double SurfaceDetector::stretch_at(std::uint32_t vertex) const {
  double most = 0;
  for (const std::uint32_t triangle : stars_[vertex]) most = std::max(most, stretch(triangle));
  return most;
}

namespace {

/// Returns the minimum of f over a triangle's corners and `others`, given by barycentric weights.
template <class F>
double least_of_points(const std::array<Vec3, 3>& x, std::span<const Vec3> others, const F& f) {
  double least = std::min({f(x[0]), f(x[1]), f(x[2])});
  for (const Vec3& w : others) least = std::min(least, f(w[0] * x[0] + w[1] * x[1] + w[2] * x[2]));
  return least;
}

/// Returns the gap between a rod and a point, m.
double gap_to(const Rod& rod, const Vec3& x) {
  const Vec3 axis = rod.to - rod.from;
  const double length = axis.squaredNorm();
  const double at = length > 0 ? std::clamp((x - rod.from).dot(axis) / length, 0.0, 1.0) : 0;
  return (x - rod.from - at * axis).norm() - rod.radius;
}

}  // namespace

std::optional<TriangleTouch> SurfaceDetector::touch(std::uint32_t triangle, const Rod& rod, double margin,
                                                    const KnownSide& known,
                                                    std::span<const Vec3> others) const {
  const auto x = corners(triangle);
  const Vec3 grow = Vec3::Constant(margin);
  if (!boxes_overlap(rod.lo - grow, rod.hi + grow, x[0].cwiseMin(x[1]).cwiseMin(x[2]),
                     x[0].cwiseMax(x[1]).cwiseMax(x[2])))
    return std::nullopt;
  const double room = gauge(longest_[triangle]) - rod.radius;
  if (room <= 0) return std::nullopt;
  const SegmentTriangle near = closest(rod.from, rod.to, x);
  if (near.distance > rod.radius + margin) return std::nullopt;
  if (near.weights.maxCoeff() >= 1) return std::nullopt;  // a vertex, handled by vertex contacts
  Vec3 side = outward(triangle);
  for (std::size_t k = 0; k < 3; ++k) {
    if (near.weights[static_cast<Eigen::Index>((k + 2) % 3)] > 0) continue;
    // On the edge (k, k+1): the lower of its two triangles reports it, unless the other triangle is nearer
    // inside. There the sum of both normals distinguishes inside from outside (Bærentzen & Aanæs 2005).
    const std::uint32_t other = neighbours_[triangle][k];
    if (other < triangle) return std::nullopt;
    if (other != triangle && closest(rod.from, rod.to, corners(other)).distance < near.distance)
      return std::nullopt;
    side += outward(other);
  }
  TriangleTouch out;
  out.triangle = triangle;
  out.weights = near.weights;
  out.point = near.weights[0] * x[0] + near.weights[1] * x[1] + near.weights[2] * x[2];
  Vec3 out_of_tissue = side.normalized();
  const Vec3 apart = near.on_segment - out.point;
  // At distances of the order of rounding the direction is random: a sheet's front and back would get
  // opposite sides.
  const bool pierced = two_sided_ ? near.distance < least_apart : near.distance == 0;
  if (two_sided_) {
    const auto before = known ? known(triangle) : std::nullopt;
    if (pierced && !before) return std::nullopt;
    const double towards_rod = out_of_tissue.dot(before ? Vec3(-*before) : apart);
    if (towards_rod == 0) return std::nullopt;
    if (towards_rod < 0) out_of_tissue = -out_of_tissue;
  }
  const bool above = apart.dot(out_of_tissue) > 0;
  if (!pierced) {
    out.normal = (above ? -1 : 1) / near.distance * apart;
    out.gap = (above ? near.distance : -near.distance) - rod.radius;
  } else {  // the rod passes through: pushed out by its end that is inside
    const double depth =
        -std::min(out_of_tissue.dot(rod.from - out.point), out_of_tissue.dot(rod.to - out.point));
    // The way out of a solid is known. For a sheet, there is none past a rod's far end.
    if (two_sided_ && depth > (most_depth - 1) * rod.radius) return std::nullopt;
    out.normal = -out_of_tissue;
    out.gap = -std::min(depth, (most_depth - 1) * rod.radius) - rod.radius;
  }
  if (!out.normal.allFinite() || out.gap < -most_depth * rod.radius) return std::nullopt;
  const double points = least_of_points(x, others, [&](const Vec3& p) { return gap_to(rod, p); });
  const double between = (points - out.gap) / rod.radius;
  if (!(between > least_between)) return std::nullopt;
  out.strength = std::min(1.0, (between - least_between) / (fully_between - least_between)) *
                 std::min(1.0, room / (full_room * rod.radius));
  return out;
}

std::optional<TriangleTouch> SurfaceDetector::near_corner(const Collider& collider, const Vec3& at,
                                                          double margin, double depth,
                                                          std::span<const Vec3> others) const {
  TriangleTouch out;
  SegmentTriangle nearest;
  nearest.distance = std::max(margin, depth);
  bool found = false;
  for (std::size_t c = 0; c < triangle_chunks_.size(); ++c) {
    const Vec3 grow = Vec3::Constant(nearest.distance);
    if (!boxes_overlap(at - grow, at + grow, triangle_chunks_[c].lo, triangle_chunks_[c].hi)) continue;
    for (std::size_t i = c * chunk_triangles; i < triangle_chunk_end(c); ++i) {
      const SegmentTriangle near = closest(at, at, corners(triangle_order_[i]));
      if (near.distance >= nearest.distance) continue;
      found = true;
      nearest = near;
      out.triangle = triangle_order_[i];
    }
  }
  if (!found || nearest.weights.maxCoeff() >= 1) return std::nullopt;  // a vertex, handled by vertex contacts
  const auto x = corners(out.triangle);
  Vec3 side = outward(out.triangle);
  bool face = true;
  for (std::size_t k = 0; k < 3; ++k)
    if (!(nearest.weights[static_cast<Eigen::Index>((k + 2) % 3)] > 0)) {  // on the edge (k, k+1)
      side += outward(neighbours_[out.triangle][k]);
      face = false;
    }
  side.normalize();
  out.weights = nearest.weights;
  out.point = nearest.weights[0] * x[0] + nearest.weights[1] * x[1] + nearest.weights[2] * x[2];
  const Vec3 apart = at - out.point;
  const bool above = apart.dot(side) > 0;
  out.gap = above ? nearest.distance : -nearest.distance;
  out.normal = face || nearest.distance < least_apart ? Vec3(-side)
                                                      : Vec3((above ? -1 : 1) / nearest.distance * apart);
  if (!out.normal.allFinite() || out.gap > margin || out.gap < -depth) return std::nullopt;
  const double points =
      least_of_points(x, others, [&](const Vec3& p) { return distance_to(collider, p, margin).value; });
  const double edge = std::max({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()});
  out.strength = std::min(1.0, (points - out.gap) / (fully_beside * edge));
  if (!(out.strength > 0)) return std::nullopt;
  return out;
}

std::vector<Rod> rods_of(const Collider& collider, double margin, const Vec3& lo, const Vec3& hi) {
  PROSECTOR_ASSERT(collider.parts != nullptr && collider.part_poses.size() == collider.parts->size());
  std::vector<Rod> out;
  const Vec3 grow = Vec3::Constant(margin);
  for (std::size_t i = 0; i < collider.parts->size(); ++i)
    if (const auto rod = rod_of((*collider.parts)[i], collider.pose * collider.part_poses[i]);
        rod && boxes_overlap(rod->lo - grow, rod->hi + grow, lo, hi))
      out.push_back(*rod);
  return out;
}

bool SurfaceDetector::touches(const Collider& collider, double margin) const {
  bool found = false;
  near(collider, margin, [&](std::uint32_t, const Distance&) { found = true; });
  if (!found) near_thin(collider, margin, {}, {}, [&](const TriangleTouch&) { found = true; });
  return found;
}

namespace {

/// Updates `best` if the part is nearer. `local`: the point in the collider's frame.
void take_nearer(const Collider& collider, std::size_t i, const Vec3& local, double margin, Distance& best) {
  const collision::ShapePart& part = (*collider.parts)[i];
  const Pose& pose = collider.part_poses[i];
  const bool primitive = part.mesh == nullptr;
  // At least the bounding radius.
  const double reach = part.half.x() + part.half.y() + part.half.z() + margin;
  if (primitive && (local - pose.p).squaredNorm() > reach * reach) return;
  const Distance d = (*collider.distances)[i]->at(pose.q.conjugate() * (local - pose.p));
  if (d.value < best.value)
    best = {d.value, collider.pose.q * (pose.q * d.normal), d.curvature, static_cast<std::uint32_t>(i)};
}

}  // namespace

Distance distance_to(const Collider& collider, const Vec3& x, double margin) {
  const Vec3 local = collider.pose.q.conjugate() * (x - collider.pose.p);
  Distance best{std::numeric_limits<double>::max(), Vec3::UnitY()};
  for (std::size_t i = 0; i < collider.parts->size(); ++i) take_nearer(collider, i, local, margin, best);
  return best;
}

Distance distance_to(const Collider& collider, const Vec3& x, double margin,
                     std::span<const std::uint32_t> parts) {
  const Vec3 local = collider.pose.q.conjugate() * (x - collider.pose.p);
  Distance best{std::numeric_limits<double>::max(), Vec3::UnitY()};
  for (const std::uint32_t i : parts) take_nearer(collider, i, local, margin, best);
  return best;
}

}  // namespace prosector::contact
