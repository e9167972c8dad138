#include "tests/bench/extreme.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "common/scene/scene.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

constexpr double side = 0.1;       // m
constexpr double frame = 1. / 60;  // s
const Vec3 weight(0, -9.81, 0);    // m/s²
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A cube of soft tissue in 48 tetrahedra, held by nothing.
TestPiece cube(std::array<std::uint32_t, 3> cells = {2, 2, 2}) {
  const SoftDesc tissue;
  TestPiece piece;
  piece.mesh = kuhn_box(cells, Vec3(side, side, side));
  piece.youngs_modulus = tissue.youngs_modulus;
  piece.poisson_ratio = tissue.poisson_ratio;
  piece.density = tissue.density;
  piece.damping_mass = tissue.damping_mass;
  piece.damping_stiffness = tissue.damping_stiffness;
  return piece;
}

/// What holds nodes is a hundred times as stiff as the piece (and 270 times as what holds organs in scenes by
/// default), so that it is no other extreme of its own.
TestPiece held(TestPiece piece) {
  piece.hold_stiffness = 100 * piece.youngs_modulus / (side * side);
  return piece;
}

TestPiece clamped(TestPiece piece = cube()) {
  piece.clamped_axis = 0;
  return held(std::move(piece));
}

TestPiece held_at_a_point(TestPiece piece = cube()) {
  piece.held_point = Vec3(0, 0, 0);
  return held(std::move(piece));
}

template <int exponent>
TestPiece stiff() {
  TestPiece piece = clamped();
  piece.youngs_modulus = std::pow(10., exponent);
  return held(std::move(piece));
}

template <int ten_thousandths>
TestPiece poisson() {
  TestPiece piece = clamped();
  piece.poisson_ratio = ten_thousandths / 1e4;
  return piece;
}

/// Layers as thick as `thickness` says, along the first `axes` of x, y, z.
TestPiece layered(const std::vector<double>& thickness, int axes) {
  const auto count = static_cast<std::uint32_t>(thickness.size());
  TestPiece piece = clamped(cube({count, axes > 1 ? count : 2, axes > 2 ? count : 2}));
  for (Vec3& p : piece.mesh.positions) {
    for (int c = 0; c < axes; ++c) {
      const auto layers = static_cast<std::size_t>(std::lround(p[c] / side * count));
      p[c] = 0;
      for (std::size_t i = 0; i < layers; ++i) p[c] += thickness[i];
    }
  }
  return piece;
}

TestPiece half_stiff() {
  TestPiece piece = clamped();
  piece.stiffness_ratio = 1e6;
  return piece;
}

TestPiece one_tetrahedron() {
  TestPiece piece = cube();
  piece.mesh.positions = {{0, 0, 0}, {side, 0, 0}, {0, side, 0}, {0, 0, side}};
  piece.mesh.tets = {{0, 1, 2, 3}};
  return held_at_a_point(std::move(piece));
}

Vec3 middle(const VecX& x) {
  return x.reshaped(3, x.size() / 3).rowwise().mean();
}

void scale_about_middle(VecX& x, const Vec3& factors) {
  const Vec3 center = middle(x);
  for (Eigen::Index k = 0; k < x.size(); k += 3)
    x.segment<3>(k) = center + factors.cwiseProduct(Vec3(x.segment<3>(k)) - center);
}

template <int x_percent, int y_percent, int z_percent>
void scaled(const TestPiece&, VecX& x, VecX&) {
  scale_about_middle(x, Vec3(x_percent, y_percent, z_percent) / 100);
}

void randomised(const TestPiece&, VecX& x, VecX&) {
  std::mt19937 random(1);  // the same start for each rung
  for (double& c : x) c = side * static_cast<double>(random()) / 4294967296.0;
}

/// What 1e6 N for one frame leaves a corner node with.
void hit(const TestPiece& piece, VecX&, VecX& v) {
  const double node_mass = piece.density * side * side * side / 64;  // about
  v.tail<3>() = Vec3(0.6, -0.64, 0.48) * 1e6 * frame / node_mass;
}

/// Held nodes belong 1 m from where they are.
void teleported(const TestPiece&, VecX& x, VecX&) {
  for (Eigen::Index k = 0; k < x.size(); k += 3) x[k] += 1;
}

std::vector<Extreme> make_extremes() {
  return {
      {"step 1e-5 s", [] { return clamped(); }, 1e-5, nullptr, weight, 2e-3, 0, false},
      {"step 1e-4 s", [] { return clamped(); }, 1e-4, nullptr, weight, 2e-2, 0, false},
      {"step 1e-3 s", [] { return clamped(); }, 1e-3, nullptr, weight, 0.1, 0.5, false},
      {"step 1/60 s", [] { return clamped(); }, frame, nullptr, weight, 1},
      {"step 0.1 s", [] { return clamped(); }, 0.1, nullptr, weight, 1},
      {"step 1 s", [] { return clamped(); }, 1, nullptr, weight, 5},
      {"E 1e2 Pa", stiff<2>, frame, nullptr, weight, 0.5, 20},
      {"E 1e4 Pa", stiff<4>, frame, nullptr, weight, 0.5},
      {"E 1e6 Pa", stiff<6>, frame, nullptr, weight, 0.5},
      {"E 1e9 Pa", stiff<9>, frame, nullptr, weight, 0.5},
      {"stiffness ratio 1e6", half_stiff, frame, nullptr, weight, 0.5},
      {"node mass ratio 1e6",
       [] {
         return layered({0.09, 0.009, 0.00095}, 3);
       },
       frame, nullptr, weight, 0.5},
      {"ν 0", poisson<0>, frame, nullptr, weight, 0.5},
      {"ν 0.49", poisson<4900>, frame, nullptr, weight, 0.5},
      {"ν 0.499", poisson<4990>, frame, nullptr, weight, 0.5},
      {"ν 0.4999", poisson<4999>, frame, nullptr, weight, 0.5},
      {"slivers",
       [] {
         return layered({0.0499, 2e-4, 0.0499}, 1);
       },
       frame, nullptr, weight, 0.5},
      {"start flat", [] { return cube(); }, frame, scaled<100, 0, 100>},
      {"start a line", [] { return cube(); }, frame, scaled<100, 0, 0>},
      {"start a point", [] { return cube(); }, frame, scaled<0, 0, 0>},
      {"start at 5 %", [] { return cube(); }, frame, scaled<5, 5, 5>},
      {"start random", [] { return cube(); }, frame, randomised},
      {"start inverted", [] { return cube(); }, frame, scaled<-100, 100, 100>},
      {"no fixed node", [] { return cube(); }, frame, nullptr, weight, 1},
      {"held by a pin",
       [] {
         TestPiece piece = clamped();
         piece.hold_stiffness = 1e13;
         return piece;
       },
       frame, nullptr, weight, 0.5},
      // Let go, it spins about the node, drawn long, until the damping of the mass has stopped it.
      {"one fixed node", [] { return held_at_a_point(); }, frame, nullptr, weight, 1, 20},
      {"1 tetrahedron", one_tetrahedron, frame, nullptr, weight, 1, 20},
      {"1e5 tetrahedra",
       [] {
         return clamped(cube({25, 26, 26}));
       },
       frame, nullptr, weight, frame, 0, false, false, false},
      {"1e6 N on the body", [] { return clamped(); }, frame, nullptr, 1e6 * weight / weight.norm() / 1.06,
       0.1},
      {"1e6 N on a node", [] { return clamped(); }, frame, hit},
      {"teleported 1 m", [] { return clamped(); }, frame, teleported},
      {"NaN gravity", [] { return clamped(); }, frame, nullptr, Vec3(nan, nan, nan), frame},
      {"NaN in the mesh",
       [] {
         TestPiece piece = clamped();
         piece.mesh.positions[3][1] = nan;
         return piece;
       },
       frame},
      {"NaN modulus",
       [] {
         TestPiece piece = clamped();
         piece.youngs_modulus = nan;
         return piece;
       },
       frame},
  };
}

/// One of each kind, none that takes long.
const char* const cheap[] = {"step 1 s",       "E 1e9 Pa",       "stiffness ratio 1e6", "ν 0.4999",
                             "slivers",        "start flat",     "start a point",       "start random",
                             "start inverted", "1 tetrahedron",  "1e6 N on a node",     "teleported 1 m",
                             "NaN gravity",    "NaN in the mesh"};

}  // namespace

const std::vector<Extreme>& extremes() {
  static const std::vector<Extreme> rows = [] {
    std::vector<Extreme> out = make_extremes();
    for (Extreme& extreme : out)
      extreme.cheap =
          std::find(std::begin(cheap), std::end(cheap), std::string(extreme.name)) != std::end(cheap);
    return out;
  }();
  return rows;
}

}  // namespace prosector
