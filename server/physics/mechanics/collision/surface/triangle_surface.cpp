#include "server/physics/mechanics/collision/surface/triangle_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/assert.h"
#include "common/error.h"

namespace prosector::collision {
namespace {

// Tolerance relative to a triangle's squared distance; rounding errors are far smaller.
constexpr double relative_tolerance = 1e-10;

bool all_finite(std::span<const Vec3> positions) {
  return std::all_of(positions.begin(), positions.end(), [](const Vec3& x) { return is_finite(x); });
}

std::vector<Vec3> checked(const SurfaceTopology& topology, std::vector<Vec3> positions) {
  if (topology.triangles().empty()) throw InputError("surface: no triangles; at least one is needed");
  if (positions.size() != topology.vertices())
    throw InputError(
        fmt::format("surface: {} positions for {} vertices", positions.size(), topology.vertices()));
  if (!all_finite(positions)) throw InputError("surface: a vertex position is not a finite number");
  return positions;
}

Vec3 unit(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

}  // namespace

TriangleSurface::TriangleSurface(const TriangleMesh& mesh)
    : TriangleSurface(std::make_shared<SurfaceTopology>(mesh.triangles, mesh.positions.size()),
                      mesh.positions) {}

TriangleSurface::TriangleSurface(std::shared_ptr<const SurfaceTopology> topology, std::vector<Vec3> positions)
    : topology_(std::move(topology)),
      positions_(checked(*topology_, std::move(positions))),
      tree_(topology_->triangles(), positions_) {}

TriangleSurface::TriangleSurface(const TriangleMesh& mesh, std::span<const std::uint32_t> order)
    : topology_(std::make_shared<SurfaceTopology>(mesh.triangles, mesh.positions.size())),
      positions_(checked(*topology_, mesh.positions)),
      tree_(topology_->triangles(), positions_, order) {}

void TriangleSurface::follow(const SurfaceEdit& edit, const TriangleMesh& mesh,
                             std::span<const std::uint32_t> order) {
  auto topology = std::make_shared<SurfaceTopology>(*topology_);  // other surfaces may share the old topology
  topology->follow(edit);
  topology_ = std::move(topology);
  PROSECTOR_ASSERT(mesh.positions.size() == topology_->vertices() &&
                   mesh.triangles.size() == topology_->triangles().size());
  positions_ = mesh.positions;
  tree_ = SurfaceTree(topology_->triangles(), positions_, order);
}

bool TriangleSurface::move(std::span<const Vec3> positions) {
  if (positions.size() != positions_.size())
    throw InputError(
        fmt::format("surface: {} positions for {} vertices", positions.size(), positions_.size()));
  if (!all_finite(positions)) return false;
  std::copy(positions.begin(), positions.end(), positions_.begin());
  tree_.refit(topology_->triangles(), positions_);
  return true;
}

std::optional<NearestPoint> TriangleSurface::nearest(const Vec3& x, double limit) const {
  NearestPoint best;
  double squared = limit * limit;
  bool found = false;
  tree_.descend([&](const Aabb& box) { return box.squared_distance(x); }, [&] { return squared; },
                [&](const SurfaceTree::Node& node) {
                  for (std::uint32_t i = node.begin; i < node.end; ++i) {
                    const std::uint32_t t = tree_.order()[i];
                    const Triangle corners = triangle(t);
                    const Vec3 weights = closest_weights(x, corners[0], corners[1], corners[2]);
                    const Vec3 point = at(corners, weights);
                    const double d = (point - x).squaredNorm();
                    if (d > squared || (found && d == squared && t > best.triangle)) continue;
                    best = {t, weights, point, 0};
                    squared = d;
                    found = true;
                  }
                });
  if (!found) return std::nullopt;
  best.distance = std::sqrt(squared);
  return best;
}

Vec3 TriangleSurface::face_normal(std::uint32_t t) const {
  const Triangle c = triangle(t);
  return unit((c[1] - c[0]).cross(c[2] - c[0]));
}

Vec3 TriangleSurface::normal_at(std::uint32_t t, const Vec3& weights) const {
  PROSECTOR_ASSERT(t < topology_->triangles().size());
  const int zeros = (weights.array() == 0).cast<int>().sum();
  if (zeros == 0) return face_normal(t);
  if (zeros == 1) {
    const std::size_t opposite = weights[0] == 0 ? 0 : weights[1] == 0 ? 1 : 2;
    return unit(face_normal(t) + face_normal(topology_->across(t, (opposite + 1) % 3)));
  }
  const std::size_t corner = weights[0] != 0 ? 0 : weights[1] != 0 ? 1 : 2;
  const std::uint32_t vertex = topology_->triangles()[t][corner];
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t u : topology_->around(vertex)) {
    const Corners& c = topology_->triangles()[u];
    const std::size_t k = c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2;
    const Vec3 p = positions_[c[(k + 1) % 3]] - positions_[vertex],
               q = positions_[c[(k + 2) % 3]] - positions_[vertex];
    sum += std::atan2(p.cross(q).norm(), p.dot(q)) * face_normal(u);
  }
  return unit(sum);
}

bool TriangleSurface::is_inside(const Vec3& x, const NearestPoint& nearest) const {
  return topology_->closed() && (x - nearest.point).dot(normal_at(nearest.triangle, nearest.weights)) < 0;
}

/// Returns how often the ray from x along +x leaves a closed surface minus how often it enters. Empty if the
/// ray passes an edge too closely to decide the side.
std::optional<int> TriangleSurface::crossings(const Vec3& x) const {
  int count = 0;
  bool sure = true;
  const auto add = [&](const Triangle& corners) {
    const Vec3 a = corners[0] - x, b = corners[1] - x, c = corners[2] - x;
    // Twice the areas of the triangles of each edge and the ray's origin, projected along +x.
    const Vec3 areas(b.y() * c.z() - b.z() * c.y(), c.y() * a.z() - c.z() * a.y(),
                     a.y() * b.z() - a.z() * b.y());
    const double reach = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
    const double tolerance = relative_tolerance * reach;
    if (areas.maxCoeff() > tolerance && areas.minCoeff() < -tolerance) return;  // the ray misses the triangle
    const double area = areas.sum();
    const double ahead = areas.dot(Vec3(a.x(), b.x(), c.x())) * (area > 0 ? 1 : -1);
    const bool crosses = areas.minCoeff() > tolerance || areas.maxCoeff() < -tolerance;
    sure = sure && crosses && std::abs(ahead) > tolerance * std::sqrt(reach);
    if (ahead > 0) count += area > 0 ? 1 : -1;
  };
  tree_.visit(
      [&](const Aabb& box) {
        return sure && box.hi.x() >= x.x() && box.lo.y() <= x.y() && box.hi.y() >= x.y() &&
               box.lo.z() <= x.z() && box.hi.z() >= x.z();
      },
      [&](const SurfaceTree::Node& node) {
        for (std::uint32_t i = node.begin; i < node.end; ++i) add(triangle(tree_.order()[i]));
      });
  return sure ? std::optional(count) : std::nullopt;
}

double TriangleSurface::winding_number(const Vec3& x) const {
  if (topology_->closed())
    if (const auto count = crossings(x)) return *count;
  double angle = 0;  // half the solid angle of all triangles (Van Oosterom and Strackee 1983)
  for (const Corners& t : topology_->triangles()) {
    const Vec3 a = positions_[t[0]] - x, b = positions_[t[1]] - x, c = positions_[t[2]] - x;
    const double u = a.norm(), v = b.norm(), w = c.norm();
    angle += std::atan2(a.dot(b.cross(c)), u * v * w + a.dot(b) * w + b.dot(c) * u + c.dot(a) * v);
  }
  return angle / (2 * std::numbers::pi);
}

std::uint32_t TriangleSurface::farthest(const Vec3& direction) const {
  // Boxes and vertices use the same summation order: rounding is monotone, so the box value stays an upper
  // bound.
  const auto height_of = [&](double x, double y, double z) {
    return (direction.x() * x + direction.y() * y) + direction.z() * z;
  };
  std::uint32_t best = 0;
  double height = -std::numeric_limits<double>::infinity();
  tree_.descend(
      [&](const Aabb& box) {
        return -height_of(direction.x() > 0 ? box.hi.x() : box.lo.x(),
                          direction.y() > 0 ? box.hi.y() : box.lo.y(),
                          direction.z() > 0 ? box.hi.z() : box.lo.z());
      },
      [&] { return -height; },
      [&](const SurfaceTree::Node& node) {
        for (std::uint32_t i = node.begin; i < node.end; ++i)
          for (const std::uint32_t v : topology_->triangles()[tree_.order()[i]]) {
            const double h = height_of(positions_[v].x(), positions_[v].y(), positions_[v].z());
            if (h < height || (h == height && v >= best)) continue;
            height = h;
            best = v;
          }
      });
  return best;
}

}  // namespace prosector::collision
