#include "common/scene/primitives.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double pi = std::numbers::pi;

// The sagitta of a circle of radius r divided into n segments is r·(1 − cos(π/n)).
int segments_around(double radius) {
  const double n = pi / std::acos(std::clamp(1 - chord_error / radius, 0.0, 0.999));
  return std::clamp(static_cast<int>(std::ceil(n / 4)) * 4, min_segments, max_segments);
}

struct ProfilePoint {
  double radius, y;
};

/// Adds a circular arc of at most a quarter turn to the profile, both ends included.
void add_arc(std::vector<ProfilePoint>& profile, double center_radius, double center_y, double arc_radius,
             double from, double to, int steps) {
  for (int k = 0; k <= steps; ++k) {
    const double a = from + (to - from) * k / steps;
    profile.push_back({center_radius + arc_radius * std::cos(a), center_y + arc_radius * std::sin(a)});
  }
}

/// Builds a surface of revolution about y. The profile runs upwards from pole to pole: its first and last
/// point are on the axis, all others are off it.
TriangleMesh surface_of_revolution(const std::vector<ProfilePoint>& profile, int around) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(around);
  const auto rings = static_cast<std::uint32_t>(profile.size() - 2);
  mesh.positions.emplace_back(0, profile.front().y, 0);
  for (std::uint32_t ring = 1; ring <= rings; ++ring)
    for (std::uint32_t k = 0; k < n; ++k) {
      const double a = 2 * pi * k / n;
      const ProfilePoint& p = profile[ring];
      mesh.positions.emplace_back(p.radius * std::cos(a), p.y, -p.radius * std::sin(a));
    }
  mesh.positions.emplace_back(0, profile.back().y, 0);

  const std::uint32_t top = 1 + rings * n;
  const auto at = [&](std::uint32_t ring, std::uint32_t k) { return 1 + ring * n + k % n; };
  for (std::uint32_t k = 0; k < n; ++k) {
    mesh.triangles.push_back({0, at(0, k + 1), at(0, k)});
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({at(ring, k), at(ring, k + 1), at(ring + 1, k + 1)});
      mesh.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring + 1, k)});
    }
    mesh.triangles.push_back({at(rings - 1, k), at(rings - 1, k + 1), top});
  }
  return mesh;
}

TriangleMesh ellipsoid(const Vec3& size) {
  const int n = segments_around(size.maxCoeff() / 2);
  std::vector<ProfilePoint> profile;
  add_arc(profile, 0, 0, 0.5, -pi / 2, pi / 2, n / 2);
  TriangleMesh mesh = surface_of_revolution(profile, n);
  for (Vec3& x : mesh.positions) x = x.cwiseProduct(size);
  return mesh;
}

TriangleMesh capsule(double diameter, double height) {
  const double r = diameter / 2, straight = std::max(0.0, height / 2 - r);
  const int n = segments_around(r);
  std::vector<ProfilePoint> profile;
  add_arc(profile, 0, -straight, r, -pi / 2, 0, n / 4);
  if (straight == 0) profile.pop_back();  // both arcs end on the same equator
  add_arc(profile, 0, straight, r, 0, pi / 2, n / 4);
  return surface_of_revolution(profile, n);
}

TriangleMesh cylinder(double diameter, double height, double rounding) {
  const double r = diameter / 2, h = height / 2;
  const double edge = std::min({rounding, 0.99 * r, 0.99 * h});
  const int steps = edge > 0 ? 4 : 0;
  std::vector<ProfilePoint> profile{{0, -h}};
  if (steps == 0) {
    profile.push_back({r, -h});
    profile.push_back({r, h});
  } else {
    add_arc(profile, r - edge, -h + edge, edge, -pi / 2, 0, steps);
    add_arc(profile, r - edge, h - edge, edge, 0, pi / 2, steps);
  }
  profile.push_back({0, h});
  return surface_of_revolution(profile, segments_around(r));
}

/// A grid line of a cube along one axis: coordinate on the inner box, and how far the rounded edge has
/// turned, −1…1.
struct GridLine {
  double inner, turn;
};

std::vector<GridLine> grid_lines(double half, double edge) {
  if (edge <= 0) return {{-half, -1}, {half, 1}};
  constexpr int steps = 4;
  const double inner = half - edge;
  std::vector<GridLine> lines;
  for (int k = 0; k <= steps; ++k) lines.push_back({-inner, -1 + static_cast<double>(k) / steps});
  if (inner < 1e-9) lines.pop_back();  // no flat part is left: both ends share their middle line
  for (int k = 0; k <= steps; ++k) lines.push_back({inner, static_cast<double>(k) / steps});
  return lines;
}

/// Builds a box's surface: a cube's grid projected onto the inner box inflated by a sphere of radius `edge`.
TriangleMesh box(const Vec3& size, double rounding) {
  const Vec3 half = size / 2;
  const double edge = std::clamp(rounding, 0.0, half.minCoeff());
  std::array<std::vector<GridLine>, 3> lines;
  for (int axis = 0; axis < 3; ++axis) lines[static_cast<std::size_t>(axis)] = grid_lines(half[axis], edge);

  TriangleMesh mesh;
  std::map<std::array<std::size_t, 3>, std::uint32_t> index_of;
  const auto vertex = [&](const std::array<std::size_t, 3>& at) {
    const auto [entry, is_new] = index_of.try_emplace(at, static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) {
      Vec3 inner, turn;
      for (std::size_t k = 0; k < 3; ++k) {
        const GridLine& line = lines[k][at[k]];
        inner[static_cast<int>(k)] = line.inner;
        turn[static_cast<int>(k)] = std::tan(line.turn * pi / 4);
      }
      mesh.positions.push_back(edge > 0 ? Vec3(inner + edge * turn.normalized()) : inner);
    }
    return entry->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool positive : {false, true})
      for (std::size_t i = 0; i + 1 < lines[u].size(); ++i)
        for (std::size_t j = 0; j + 1 < lines[v].size(); ++j) {
          const auto corner = [&](std::size_t di, std::size_t dj) {
            std::array<std::size_t, 3> at{};
            at[axis] = positive ? lines[axis].size() - 1 : 0;
            at[u] = i + di;
            at[v] = j + dj;
            return vertex(at);
          };
          std::array<std::uint32_t, 4> quad = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
          if (!positive) std::reverse(quad.begin(), quad.end());
          mesh.triangles.push_back({quad[0], quad[1], quad[2]});
          mesh.triangles.push_back({quad[0], quad[2], quad[3]});
        }
  }
  return mesh;
}

TriangleMesh unplaced_mesh(const PartDesc& part) {
  if (part.shape == "box") return box(part.size, part.rounding);
  if (part.shape == "sphere") return ellipsoid(Vec3::Constant(part.size.x()));
  if (part.shape == "capsule") return capsule(part.size.x(), part.size.y());
  if (part.shape == "cylinder") return cylinder(part.size.x(), part.size.y(), part.rounding);
  if (part.shape == "ellipsoid") return ellipsoid(part.size);
  throw InputError(fmt::format("part: unknown shape '{}'; allowed: box, sphere, capsule, cylinder, ellipsoid",
                               part.shape));
}

}  // namespace

TriangleMesh mesh_of(const PartDesc& part) {
  const int extents = part.shape == "sphere"                                ? 1
                      : part.shape == "capsule" || part.shape == "cylinder" ? 2
                                                                            : 3;
  if (!is_finite(part.size) || !(part.size.head(extents).minCoeff() > 0))
    throw InputError(fmt::format("part: size {} × {} × {} m of a {} must be positive", part.size.x(),
                                 part.size.y(), part.size.z(), part.shape));
  TriangleMesh mesh = unplaced_mesh(part);
  for (Vec3& x : mesh.positions) x = part.pose * x;
  return mesh;
}

TriangleMesh mesh_of(std::span<const PartDesc> parts) {
  TriangleMesh all;
  for (const PartDesc& part : parts) append(all, mesh_of(part));
  return all;
}

}  // namespace prosector
