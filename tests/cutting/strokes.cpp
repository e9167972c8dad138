#include "tests/cutting/strokes.h"

#include <cmath>

#include "server/physics/mechanics/cutting/carry.h"
#include "tests/cutting/meshes.h"

namespace prosector {
namespace {

constexpr double L = mesh_size;

Stroke scaled(Stroke stroke) {
  for (auto& edge : stroke)
    for (Vec3& x : edge) x *= L;
  return stroke;
}

// The edge a–b moved by `way` in `ticks`.
Stroke sweep(const Vec3& a, const Vec3& b, const Vec3& way, int ticks) {
  Stroke stroke;
  for (int i = 0; i <= ticks; ++i) {
    const Vec3 at = way * i / ticks;
    stroke.push_back({a + at, (a + b) / 2 + at, b + at});
  }
  return scaled(stroke);
}

Stroke arc(int ticks) {
  Stroke stroke;
  for (int i = 0; i <= ticks; ++i) {
    const double s = -0.1 + 1.2 * i / ticks;
    std::vector<Vec3> edge;
    for (int k = 0; k <= 4; ++k) {
      const double h = -0.1 + 0.3 * k;
      edge.push_back({s, 0.5 + 0.2 * std::sin(3 * s) * (1 - 0.5 * h), h});
    }
    stroke.push_back(edge);
  }
  return scaled(stroke);
}

Stroke sawing() {
  Stroke stroke;
  double depth = 1.1;
  for (int i = 0; i < 40; ++i) {
    const double shift = i % 2 == 0 ? -0.05 : 0.05;
    stroke.push_back({{0.47, depth, -0.3 + shift}, {0.47, depth, 1.3 + shift}});
    if (i % 3 != 2) depth -= 0.05;
    if (i % 7 == 6) depth += 0.04;
  }
  return scaled(stroke);
}

}  // namespace

Stroke across(const Vec3& middle, const Vec3& normal, int ticks) {
  const Vec3 n = normal.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
  return sweep(middle - 1.5 * u - 1.5 * v, middle + 1.5 * u - 1.5 * v, 3 * v, ticks);
}

std::vector<NamedStrokes> strokes_to_make() {
  const Vec3 c = Vec3::Constant(0.5), odd(0.3, 1, 0.2);
  const Stroke straight = across({0.5, 0.53, 0.5}, odd, 1);
  std::vector<NamedStrokes> table = {
      {"none", {}, 1},
      {"across at once", {straight}, 2},
      {"across in 25 ticks", {across({0.5, 0.53, 0.5}, odd, 25)}, 2},
      {"through vertices and along faces", {across(c, {1, 0, 0}, 1)}, 2},
      {"through vertices in 17 ticks", {across(c, {0, 1, 0}, 17)}, 2},
      {"along diagonals", {across(c, {1, -1, 0}, 1)}, 2},
      {"through one vertex", {across(Vec3(0.25, 0.5, 0.75), odd, 1)}, 2},
      {"along the boundary", {across({0, 0.5, 0.5}, {1, 0, 0}, 1)}, 1},
      {"a hair inside the boundary", {across({1e-4, 0.5, 0.5}, {1, 0, 0}, 1)}, 1},
      {"half through", {sweep({0.5, 1.2, -0.2}, {0.5, 1.2, 1.2}, {0.1, -0.7, 0}, 1)}, 1},
      {"half through in 9 ticks", {sweep({0.5, 1.2, -0.2}, {0.5, 1.2, 1.2}, {0.1, -0.7, 0}, 9)}, 1},
      {"a stab", {sweep({0.4, 1.2, 0.4}, {0.5, 1.2, 0.6}, {0, -0.8, 0}, 4)}, 1},
      {"buried", {sweep({0.3, 0.3, 0.31}, {0.7, 0.32, 0.3}, {0, 0.4, 0.1}, 3)}, 1},
      {"a micrometre", {sweep({0.3, 0.41, 0.31}, {0.7, 0.42, 0.3}, {0, 1e-5, 0}, 1)}, 1},
      {"standing still", {sweep({0.3, 0.3, 0.31}, {0.7, 0.32, 0.3}, {0, 0, 0}, 3)}, 1},
      {"curved", {arc(1)}, 0},
      {"curved in 20 ticks", {arc(20)}, 2},
      {"crossing", {straight, across(c, {1, 0.1, 0.3}, 1), across(c, {0.1, 0.2, 1}, 6)}, 8},
      {"the same twice", {straight, straight}, 2},
      {"overlapping", {straight, across({0.5, 0.531, 0.5}, odd, 5)}, 2},
      {"thin slices", {across({0.5, 0.5, 0.5}, odd, 1), across({0.5, 0.56, 0.5}, odd, 1)}, 0},
      {"sawing", {sawing()}, 2},
      {"beside it", {sweep({2, 2, 2}, {3, 2, 2}, {0, 1, 0}, 3)}, 1},
  };
  return table;
}

std::vector<Vec3> rest_positions(const cutting::TetComplex& complex) {
  std::vector<Vec3> x;
  for (cutting::NodeId i = 0; i < complex.node_end(); ++i) x.push_back(complex.rest(i));
  return x;
}

cutting::CutResult cut_and_carry(cutting::TetComplex& complex, cutting::TetTree& tree, std::vector<Vec3>& x,
                                 const std::vector<Vec3>& edge, cutting::BladeStroke& stroke) {
  cutting::CutResult result = cutting::cut(complex, tree, x, edge, stroke);
  for (const cutting::TopologyOp& op : result.ops) cutting::carry(op, x);
  return result;
}

}  // namespace prosector
