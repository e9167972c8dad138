#include "tests/bench/extreme.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "common/anatomy/sheets_and_ropes.h"
#include "common/scene/scene.h"
#include "tests/bench/specimen_measures.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

constexpr double side = 0.1;       // m
constexpr double frame = 1. / 60;  // s
const Vec3 weight(0, -9.81, 0);    // m/s²
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool solid(PieceMesh mesh) {
  return mesh == PieceMesh::tets || mesh == PieceMesh::few_tets;
}

/// Material constants: soft tissue for solids; skin-like sheets and ropes, whose bending stiffness recovers
/// the shape in time.
TestPiece material(PieceMesh mesh) {
  const SoftDesc tissue;
  TestPiece piece;
  piece.youngs_modulus = solid(mesh) ? tissue.material.youngs_modulus : 1e6;
  piece.poisson_ratio = solid(mesh) ? tissue.material.poisson_ratio : 0.3;
  piece.density = tissue.material.density;
  piece.damping_mass = tissue.material.damping_mass;
  piece.damping_stiffness = tissue.material.damping_stiffness;
  return piece;
}

/// Returns a free cube of tetrahedra.
TestPiece cube(std::array<std::uint32_t, 3> cells) {
  TestPiece piece = material(PieceMesh::tets);
  piece.mesh = kuhn_box(cells, Vec3(side, side, side));
  return piece;
}

/// Returns a free sheet of cells × cells, or a free rope of `cells` segments.
TestPiece fabric(PieceMesh mesh, std::uint32_t cells) {
  TestPiece piece = material(mesh);
  const double cell = side / cells;
  Anatomy anatomy =
      mesh == PieceMesh::sheet ? make_sheet({side, 0.002, side}, cell) : make_rope({side, 0.002, 0}, cell);
  const Vec3 corner = anatomy.tets.positions.front();
  for (Vec3& p : anatomy.tets.positions) p -= corner;
  piece.mesh.positions = std::move(anatomy.tets.positions);
  piece.quads = std::move(anatomy.quads);
  piece.segments = std::move(anatomy.segments);
  piece.thickness = anatomy.thickness;
  return piece;
}

/// Returns the default piece: 48 tetrahedra (12 for few_tets), 16 sheet cells or 8 rope segments.
TestPiece plain(PieceMesh mesh) {
  if (mesh == PieceMesh::tets) return cube({2, 2, 2});
  if (mesh == PieceMesh::few_tets) return cube({2, 1, 1});
  return fabric(mesh, mesh == PieceMesh::sheet ? 4 : 8);
}

double volume(const TestPiece& piece) {
  const double t = piece.thickness;
  if (!piece.quads.empty()) return side * side * t;
  return piece.segments.empty() ? side * side * side : side * M_PI * t * t / 4;
}

/// Sets the attachment stiffness to 100 times the piece's (270 times a scene's default), so that the
/// attachment is not an extreme itself.
TestPiece held(TestPiece piece) {
  piece.hold_stiffness = 100 * piece.youngs_modulus / (side * side);
  return piece;
}

TestPiece clamped(TestPiece piece) {
  piece.clamped_axis = 0;
  return held(std::move(piece));
}
TestPiece clamped(PieceMesh mesh) {
  return clamped(plain(mesh));
}

TestPiece held_at_a_point(TestPiece piece) {
  piece.held_point = Vec3(0, 0, 0);
  return held(std::move(piece));
}

TestPiece held_by_a_pin(PieceMesh mesh) {
  TestPiece piece = clamped(mesh);
  piece.hold_stiffness = 1e13;
  return piece;
}

template <int exponent>
TestPiece stiff(PieceMesh mesh) {
  TestPiece piece = clamped(mesh);
  piece.youngs_modulus = std::pow(10., exponent);
  return held(std::move(piece));
}

template <int ten_thousandths>
TestPiece poisson(PieceMesh mesh) {
  TestPiece piece = clamped(mesh);
  piece.poisson_ratio = ten_thousandths / 1e4;
  return piece;
}

/// Gives mesh layers the thicknesses `thickness` along the first `axes` of x, y, z. Sheets lie in x and z.
TestPiece layered(PieceMesh mesh, const std::vector<double>& thickness, int axes) {
  const auto count = static_cast<std::uint32_t>(thickness.size());
  const std::uint32_t other = mesh == PieceMesh::few_tets ? 1 : 2;
  TestPiece piece = clamped(solid(mesh) ? cube({count, axes > 1 ? count : other, axes > 2 ? count : other})
                                        : fabric(mesh, count));
  for (Vec3& p : piece.mesh.positions) {
    for (int c = 0; c < axes; ++c) {
      const auto layers = static_cast<std::size_t>(std::lround(p[c] / side * count));
      p[c] = 0;
      for (std::size_t i = 0; i < layers; ++i) p[c] += thickness[i];
    }
  }
  return piece;
}

TestPiece slivers(PieceMesh mesh) {
  return layered(mesh, {0.0499, 2e-4, 0.0499}, 1);
}

/// Returns a graded piece whose lightest corner node has a millionth of the heaviest node's mass.
TestPiece unlike_masses(PieceMesh mesh) {
  if (solid(mesh)) return layered(mesh, {0.09, 0.009, 0.00095}, 3);
  if (mesh == PieceMesh::sheet) return layered(mesh, {0.09, 0.009, 0.0009, 0.00009}, 3);
  return layered(mesh, {0.09, 0.009, 9e-4, 9e-5, 9e-6, 9e-7, 9e-8}, 1);
}

TestPiece half_stiff(PieceMesh mesh) {
  TestPiece piece = clamped(mesh);
  piece.stiffness_ratio = 1e6;
  return piece;
}

TestPiece one_element(PieceMesh mesh) {
  if (!solid(mesh)) return held_at_a_point(fabric(mesh, 1));
  TestPiece piece = material(mesh);
  piece.mesh.positions = {{0, 0, 0}, {side, 0, 0}, {0, side, 0}, {0, 0, side}};
  piece.mesh.tets = {{0, 1, 2, 3}};
  return held_at_a_point(std::move(piece));
}

TestPiece fine(PieceMesh mesh) {
  return clamped(solid(mesh) ? cube({25, 26, 26}) : fabric(mesh, 316));
}

TestPiece spoilt_mesh(PieceMesh mesh) {
  TestPiece piece = clamped(mesh);
  piece.mesh.positions[3][1] = nan;
  return piece;
}

TestPiece spoilt_modulus(PieceMesh mesh) {
  TestPiece piece = clamped(mesh);
  piece.youngs_modulus = nan;
  return piece;
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
  std::mt19937 random(1);  // the same initial state for each configuration
  for (double& c : x) c = side * static_cast<double>(random()) / 4294967296.0;
}

/// Sets the velocity that 1e6 N for one frame gives a corner node.
void hit(const TestPiece& piece, VecX&, VecX& v) {
  const double node_mass = piece.density * volume(piece) / static_cast<double>(v.size());  // approximate
  v.tail<3>() = Vec3(0.6, -0.64, 0.48) * 1e6 * frame / node_mass;
}

/// Starts with the held nodes 1 m from their attachments.
void teleported(const TestPiece&, VecX& x, VecX&) {
  for (Eigen::Index k = 0; k < x.size(); k += 3) x[k] += 1;
}

std::vector<Extreme> make_extremes() {
  return {
      {"step 1e-5 s", clamped, 1e-5, nullptr, weight, 2e-3, 0, false},
      {"step 1e-4 s", clamped, 1e-4, nullptr, weight, 2e-2, 0, false},
      {"step 1e-3 s", clamped, 1e-3, nullptr, weight, 0.1, 0.5, false},
      {"step 1/60 s", clamped, frame, nullptr, weight, 1},
      {"step 0.1 s", clamped, 0.1, nullptr, weight, 1},
      {"step 1 s", clamped, 1, nullptr, weight, 5},
      {"E 1e2 Pa", stiff<2>, frame, nullptr, weight, 0.5, 30},
      {"E 1e4 Pa", stiff<4>, frame, nullptr, weight, 0.5},
      {"E 1e6 Pa", stiff<6>, frame, nullptr, weight, 0.5},
      {"E 1e9 Pa", stiff<9>, frame, nullptr, weight, 0.5},
      {"stiffness ratio 1e6", half_stiff, frame, nullptr, weight, 0.5, 5, true, on_tets},
      {"node mass ratio 1e6", unlike_masses, frame, nullptr, weight, 0.5},
      {"ν 0", poisson<0>, frame, nullptr, weight, 0.5, 5, true, on_tets | on_sheets},
      {"ν 0.49", poisson<4900>, frame, nullptr, weight, 0.5, 5, true, on_tets | on_sheets},
      {"ν 0.499", poisson<4990>, frame, nullptr, weight, 0.5, 5, true, on_tets | on_sheets},
      {"ν 0.4999", poisson<4999>, frame, nullptr, weight, 0.5, 5, true, on_tets | on_sheets},
      {"slivers", slivers, frame, nullptr, weight, 0.5},
      {"start flat", plain, frame, scaled<100, 0, 100>, {0, 0, 0}, 0, 5, true, on_tets},
      {"start a line", plain, frame, scaled<100, 0, 0>, {0, 0, 0}, 0, 5, true, on_tets | on_sheets},
      {"start a point", plain, frame, scaled<0, 0, 0>},
      {"start at 5 %", plain, frame, scaled<5, 5, 5>},
      {"start random", plain, frame, randomised},
      {"start inverted", plain, frame, scaled<-100, 100, 100>, {0, 0, 0}, 0, 5, true, on_tets},
      {"no fixed node", plain, frame, nullptr, weight, 1},
      {"held by a pin", held_by_a_pin, frame, nullptr, weight, 0.5},
      // After release it spins about the node, stretched, until mass-proportional damping stops it.
      {"one fixed node", [](PieceMesh mesh) { return held_at_a_point(plain(mesh)); }, frame, nullptr, weight,
       1, 20},
      {"1 element", one_element, frame, nullptr, weight, 1, 20},
      {"1e5 elements", fine, frame, nullptr, weight, frame, 0, false, on_tets | on_sheets, 0, false, false},
      {"1e6 N on the body", clamped, frame, nullptr, weight, 0.1, 5, true, on_all, 1e6},
      {"1e6 N on a node", clamped, frame, hit},
      {"teleported 1 m", clamped, frame, teleported},
      {"NaN gravity", clamped, frame, nullptr, Vec3(nan, nan, nan), frame},
      {"NaN in the mesh", spoilt_mesh, frame},
      {"NaN modulus", spoilt_modulus, frame},
      {.name = "two organs and a hand", .piece = nullptr, .meshes = on_tets, .organs = true},
  };
}

/// Fast extremes, one of each kind.
const char* const cheap[] = {"step 1 s",       "E 1e9 Pa",       "stiffness ratio 1e6", "ν 0.4999",
                             "slivers",        "start flat",     "start a point",       "start random",
                             "start inverted", "1 element",      "1e6 N on a node",     "teleported 1 m",
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

namespace {

double length_error(const TestPiece& piece, const VecX& rest, const VecX& x) {
  double worst = 0;
  const auto look = [&](std::uint32_t a, std::uint32_t b) {
    const auto length = [&](const VecX& at) {
      return (at.segment<3>(3 * Eigen::Index{a}) - at.segment<3>(3 * Eigen::Index{b})).norm();
    };
    worst = std::max(worst, std::abs(length(x) - length(rest)));
  };
  for (const auto& s : piece.segments) look(s[0], s[1]);
  for (const auto& q : piece.quads)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b) look(q[a], q[b]);
  return x.allFinite() ? worst : std::numeric_limits<double>::infinity();
}

/// Returns the period of a free rope's slowest bending mode, s: ω = (4.73/L)²·√(EI/ρA), I/A = d²/16.
double bending_period(const TestPiece& piece) {
  const double d = piece.thickness;
  const double omega = std::pow(4.73 / side, 2) * std::sqrt(piece.youngs_modulus / piece.density) * d / 4;
  return 2 * M_PI / omega;
}

}  // namespace

double misfit(const TestPiece& piece, const VecX& rest, const VecX& x, const VecX& node_mass,
              double seconds) {
  const bool limp = !piece.segments.empty() && 2 * bending_period(piece) > seconds;
  if (limp || !piece.quads.empty()) return length_error(piece, rest, x);
  return shape_error(rest, x, node_mass);
}

}  // namespace prosector
