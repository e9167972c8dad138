#include "tests/collision/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace prosector::test {

double between(Random& random, double lo, double hi) {
  return std::uniform_real_distribution<double>(lo, hi)(random);
}

Vec3 random_point(Random& random, double size) {
  const double x = between(random, -size, size), y = between(random, -size, size);
  return {x, y, between(random, -size, size)};
}

Vec3 random_unit(Random& random) {
  for (;;)
    if (const Vec3 x = random_point(random); x.norm() > 0.1 && x.norm() < 1) return x.normalized();
}

Quat random_turn(Random& random) {
  const Vec3 axis = random_unit(random);
  return Quat(Eigen::AngleAxisd(between(random, 0, 2 * std::numbers::pi), axis));
}

Pose random_pose(Random& random, double size) {
  const Vec3 p = random_point(random, size);
  return {p, random_turn(random)};
}

TriangleMesh ball_mesh(int levels) {
  TriangleMesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, fresh] =
          middles.try_emplace(std::minmax({a, b}), static_cast<std::uint32_t>(mesh.positions.size()));
      if (fresh) mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]).normalized());
      return at->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

TriangleMesh organ_mesh(int levels, const Vec3& size) {
  TriangleMesh mesh = ball_mesh(levels);
  for (Vec3& x : mesh.positions) {
    const double r = 1 + 0.2 * std::sin(3 * x.x() + 1) * std::cos(2 * x.y()) -
                     0.25 * std::exp(-8 * (x - Vec3::UnitZ()).squaredNorm());
    x = (r * x).cwiseProduct(size) / 2;
  }
  return mesh;
}

TriangleMesh horseshoe_mesh() {
  // Outline of the U in the plane, anticlockwise; drawn out along z.
  const std::vector<std::array<double, 2>> outline = {{-0.5, -0.5}, {0.5, -0.5},  {0.5, 0.5},  {0.2, 0.5},
                                                      {0.2, -0.2},  {-0.2, -0.2}, {-0.2, 0.5}, {-0.5, 0.5}};
  const std::vector<std::array<std::uint32_t, 3>> front = {{0, 1, 4}, {0, 4, 5}, {1, 2, 3},
                                                           {1, 3, 4}, {0, 5, 6}, {0, 6, 7}};
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const double z : {0.15, -0.15})
    for (const auto& [x, y] : outline) mesh.positions.emplace_back(x, y, z);
  for (const auto& [a, b, c] : front) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({n + a, n + c, n + b});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, n + i, n + j});
    mesh.triangles.push_back({i, n + j, j});
  }
  return mesh;
}

TriangleMesh sheet_mesh(int cells, double size) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(cells);
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i)
      mesh.positions.emplace_back(size * i / n - size / 2, 0, size * j / n - size / 2);
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + n + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  return mesh;
}

std::vector<Vec3> random_cloud(Random& random, int points) {
  std::vector<Vec3> out;
  const Vec3 size(between(random, 0.1, 1), between(random, 0.1, 1), between(random, 0.1, 1));
  for (int i = 0; i < points; ++i) out.push_back(random_unit(random).cwiseProduct(size));
  return out;
}

TriangleMesh moved(const TriangleMesh& mesh, const Pose& pose) {
  TriangleMesh out = mesh;
  for (Vec3& x : out.positions) x = pose * x;
  return out;
}

collision::ShapePart mesh_part(const TriangleMesh& mesh) {
  return {collision::ShapeKind::triangles, Vec3::Zero(), {}, std::make_shared<TriangleMesh>(mesh)};
}

namespace {

std::vector<NamedParts> make_table() {
  std::vector<NamedParts> table;
  table.push_back({"box", {{collision::ShapeKind::box, {0.05, 0.03, 0.04}, {}, nullptr}}});
  table.push_back({"ellipsoid", {{collision::ShapeKind::ellipsoid, {0.05, 0.03, 0.02}, {}, nullptr}}});
  table.push_back({"cylinder", {{collision::ShapeKind::cylinder, {0.03, 0.05, 0.03}, {}, nullptr}}});
  TriangleMesh horseshoe = horseshoe_mesh();
  for (Vec3& x : horseshoe.positions) x *= 0.1;
  table.push_back({"horseshoe", {mesh_part(horseshoe)}});
  table.push_back({"plate", {{collision::ShapeKind::box, {0.05, 0.001, 0.04}, {}, nullptr}}});
  table.push_back({"organ", {mesh_part(organ_mesh(3, {0.12, 0.07, 0.09}))}});
  std::vector<collision::ShapePart> hand{{collision::ShapeKind::box, {0.04, 0.012, 0.04}, {}, nullptr}};
  for (int finger = 0; finger < 4; ++finger)
    for (int bone = 0; bone < 3; ++bone) {
      const Vec3 at(-0.03 + 0.02 * finger, -0.004 * bone, 0.055 + 0.025 * bone);
      const Quat along(Eigen::AngleAxisd(std::numbers::pi / 2 + 0.3 * bone, Vec3::UnitX()));
      hand.push_back({collision::ShapeKind::capsule, {0.008, 0.01, 0.008}, {at, along}, nullptr});
    }
  table.push_back({"hand", hand});
  return table;
}

}  // namespace

const std::vector<NamedParts>& shape_table() {
  static const std::vector<NamedParts> table = make_table();
  return table;
}

CollisionObject from_table(std::size_t shape, Fidelity fidelity, const Pose& pose) {
  static std::map<std::pair<std::size_t, Fidelity>, std::shared_ptr<const collision::RigidOutline>> outlines;
  std::shared_ptr<const collision::RigidOutline>& outline = outlines[{shape, fidelity}];
  if (!outline) outline = std::make_shared<collision::RigidOutline>(shape_table()[shape].parts, fidelity);
  CollisionObject out(outline);
  out.place(pose);
  return out;
}

CollisionObject rigid(const std::vector<collision::ShapePart>& parts, Fidelity fidelity, const Pose& pose) {
  CollisionObject out(std::make_shared<collision::RigidOutline>(parts, fidelity));
  out.place(pose);
  return out;
}

double brute_force_depth(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::vector<Vec3> normals;
  std::array<std::vector<Vec3>, 2> edges;
  for (std::size_t which = 0; which < 2; ++which) {
    const std::vector<Vec3>& points = which == 0 ? a : b;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = i + 1; j < points.size(); ++j) {
        bool edge = false;
        for (std::size_t k = 0; k < points.size(); ++k) {
          if (k == i || k == j) continue;
          const Vec3 n = (points[j] - points[i]).cross(points[k] - points[i]).normalized();
          double lo = 0, hi = 0;
          for (const Vec3& x : points) {
            lo = std::min(lo, n.dot(x - points[i]));
            hi = std::max(hi, n.dot(x - points[i]));
          }
          if (lo < -1e-12 && hi > 1e-12) continue;
          edge = true;
          normals.push_back(n);
        }
        if (edge) edges[which].push_back(points[j] - points[i]);
      }
  }
  for (const Vec3& e : edges[0])
    for (const Vec3& f : edges[1])
      if (const Vec3 n = e.cross(f); n.norm() > 1e-10) normals.push_back(n.normalized());
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& n : normals) {
    double lo_a = 1e300, hi_a = -1e300, lo_b = 1e300, hi_b = -1e300;
    for (const Vec3& x : a) lo_a = std::min(lo_a, n.dot(x)), hi_a = std::max(hi_a, n.dot(x));
    for (const Vec3& x : b) lo_b = std::min(lo_b, n.dot(x)), hi_b = std::max(hi_b, n.dot(x));
    least = std::min({least, hi_a - lo_b, hi_b - lo_a});
  }
  return least;
}

}  // namespace prosector::test
