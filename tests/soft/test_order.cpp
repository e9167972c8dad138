// How fast finite elements approach closed forms when the mesh is refined, against theory (Strang & Fix
// 1973).
//
// With polynomials of degree p the stored energy errs by the square of the energy norm of the error:
// h^2p where the solution is smooth (2 for linear, 4 for quadratic elements). Three things lower that:
// - Corners. A solution that goes as r^s (displacement) around an edge limits energies to h^2s, whatever
//   p, on meshes that are not graded towards it: a re-entrant or clamped edge has s < 1. An r² log r, as
//   a square bar's warping has at its edges, costs quadratic elements a logarithm: h⁴·log(1/h).
// - The mean dilatation of quadratic elements above ν = 0.2 (mean_dilatation.h) is a pressure constant in
//   each element, so where the dilatation varies energies err by h² (Boffi, Brezzi, Fortin 2013, 8.2).
// - The lumped mass is a quadrature exact for linear fields only: frequencies err by h² (Fix 1972).
// The specimens here are slices of one layer of cells, so that many resolutions cost little.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "tests/soft/kuhn.h"
#include "tests/soft/statics.h"

namespace prosector {
namespace {

constexpr double side = 0.1;  // m, of all cross-sections
constexpr double E = 1e5;     // Pa

/// Of errors at n and 2n cells.
double order(double coarse, double fine) {
  return std::log2(std::abs(coarse / fine));
}

TetMesh centred(TetMesh mesh) {
  for (Vec3& p : mesh.positions) p.y() -= side / 2;
  return mesh;
}

/// What `load` does on its way, over the exact strain energy: 1 − U_h/U. Never negative for elements
/// that conform, and then the error's energy.
double shortfall(const Specimen& specimen, const VecX& load, double exact) {
  const VecX x = free_equilibrium(specimen, load);
  return 1 - load.dot(x - specimen.model->rest()) / 2 / exact;
}

/// A beam bent by a force P at its end, ν = 0, loaded at both ends as Timoshenko's cubic solution is
/// (Timoshenko & Goodier, art. 21): σ_x = −P(L−x)y/I, τ = P(a²/4 − y²)/2I, the same for all z. Its end sinks
/// by PL³/3EI + 6PL/5GA in the mean, weighted by τ.
double flexure_error(const std::string& element, std::uint32_t n) {
  const double L = 2 * side, P = 1, width = side / n, area = side * width;
  const double I = width * std::pow(side, 3) / 12, G = E / 2;
  const Specimen beam =
      make_specimen("fem_linear", element, E, 0, centred(kuhn_box({2 * n, n, 1}, Vec3(L, side, width))));
  const VecX load = forces_of(beam, [&](const Vec3& p, const Vec3& normal) -> Vec3 {
    if (std::abs(normal.x()) < 0.5) return Vec3::Zero();
    const double y = p.y();
    return normal.x() * Vec3(-P * (L - p.x()) * y / I, P / (2 * I) * (side * side / 4 - y * y), 0);
  });
  return shortfall(beam, load, P / 2 * (P * std::pow(L, 3) / (3 * E * I) + 6 * P * L / (5 * G * area)));
}

TEST(Order, OfACantileverUnderAnEndLoad) {
  EXPECT_NEAR(order(flexure_error("tet4", 16), flexure_error("tet4", 32)), 2, 0.1);
  const double coarse = flexure_error("tet10", 4), fine = flexure_error("tet10", 8);
  EXPECT_NEAR(order(coarse, fine), 4, 0.15);
  EXPECT_GT(fine, 0);
  EXPECT_LT(fine, 2e-5);
}

/// Curvature κ by moments at the ends: σ_x = Eκy, displacements of degree two.
double bending_error(double nu, std::uint32_t n) {
  const double curvature = 1, width = side / n, I = width * std::pow(side, 3) / 12;
  const Specimen beam =
      make_specimen("fem_linear", "tet10", E, nu, centred(kuhn_box({n, n, 1}, Vec3(side, side, width))));
  const VecX load = forces_of(beam, [&](const Vec3& p, const Vec3& normal) -> Vec3 {
    return std::abs(normal.x()) < 0.5 ? Vec3::Zero() : Vec3(normal.x() * E * curvature * p.y(), 0, 0);
  });
  return shortfall(beam, load, E * I * curvature * curvature * side / 2);
}

/// Quadratic elements hold it exactly, until their dilatation is averaged.
TEST(Order, OfTheMeanDilatationInPureBending) {
  EXPECT_NEAR(bending_error(0.2, 2), 0, 1e-11);
  for (const double nu : {0.3, 0.45, 0.49}) {
    const double coarse = bending_error(nu, 8), fine = bending_error(nu, 16);
    EXPECT_NEAR(order(coarse, fine), 2, 0.1) << nu;
    EXPECT_LT(fine, 0) << "too soft, not too stiff";
    EXPECT_GT(bending_error(nu, 4), -5e-3);
  }
}

/// Ends of a slice of length L turned about the origin of its section against each other by θL, free to
/// warp: Saint-Venant's W = ½·G·J·θ²L is exact, and elements store more.
double torsion_error(const std::string& element, double nu, const TetMesh& slice, double length, double J) {
  const double twist = 1, L = length;
  const Specimen bar = make_specimen("fem_linear", element, E, nu, slice);
  const Vec3 first = bar.mesh.positions[0];  // held along x too, or all could slide
  const auto turned = [&](const Vec3& p, int c) -> std::optional<double> {
    const bool is_end = std::abs(p.x() - L / 2) > L / 2 - 1e-9;
    if (!is_end) return std::nullopt;
    const double angle = twist * (p.x() - L / 2);
    if (c == 1) return p.y() - angle * p.z();
    if (c == 2) return p.z() + angle * p.y();
    return p == first ? std::optional(p.x()) : std::nullopt;
  };
  const VecX x = equilibrium(*bar.model, turned, VecX::Zero(bar.model->rest().size()));
  const double G = E / (2 * (1 + nu));
  return bar.model->energy(x.data()) / (0.5 * G * J * twist * twist * L) - 1;
}

/// One layer of a bar of equilateral section around its axis: half of the cells of a box, sheared.
TetMesh triangular_slice(std::uint32_t n) {
  const TetMesh box = kuhn_box({1, n, n}, Vec3(side / n, 1, 1));
  TetMesh slice;
  std::map<std::uint32_t, std::uint32_t> kept;
  for (auto tet : box.tets) {
    double beyond = 0;  // the diagonal y = z, which all cells are divided along
    for (const std::uint32_t node : tet) beyond += box.positions[node].z() - box.positions[node].y();
    if (beyond > 0) continue;
    for (std::uint32_t& node : tet) {
      const auto [at, is_new] = kept.try_emplace(node, static_cast<std::uint32_t>(slice.positions.size()));
      if (is_new) {
        const Vec3& p = box.positions[node];
        slice.positions.emplace_back(p.x(), side * (p.y() - p.z() / 2 - 0.5),
                                     side * std::sqrt(3) * (p.z() / 2 - 1. / 6));
      }
      node = at->second;
    }
    slice.tets.push_back(tet);
  }
  return slice;
}

/// A cubic warps this bar: nothing is singular at its 60° edges. J = √3/80·a⁴.
TEST(Order, OfTorsionOfATriangularBar) {
  const double J = std::sqrt(3) / 80 * std::pow(side, 4);
  for (const double nu : {0.3, 0.49}) {
    const auto error = [&](const char* element, std::uint32_t n) {
      return torsion_error(element, nu, triangular_slice(n), side / n, J);
    };
    EXPECT_NEAR(order(error("tet4", 16), error("tet4", 32)), 2, 0.1) << nu;
    const double fine = error("tet10", 8);
    EXPECT_NEAR(order(error("tet10", 4), fine), 4, 0.1) << nu;
    EXPECT_GT(fine, 0);
    EXPECT_LT(fine, 2e-4);
  }
}

/// The warping of a square goes as r² log r at its edges: linear elements don't notice, quadratic ones
/// err by h⁴(A + B·log(1/h)), so error/h⁴ grows by the same amount with each halving of h.
TEST(Order, OfTorsionOfASquareBar) {
  const double J = 0.140577014955 * std::pow(side, 4);
  const auto error = [&](const char* element, double nu, std::uint32_t n) {
    TetMesh slice = centred(kuhn_box({1, n, n}, Vec3(side / n, side, side)));
    for (Vec3& p : slice.positions) p.z() -= side / 2;
    return torsion_error(element, nu, slice, side / n, J);
  };
  for (const double nu : {0.3, 0.49})
    EXPECT_NEAR(order(error("tet4", nu, 16), error("tet4", nu, 32)), 2, 0.1) << nu;
  std::array<double, 4> scaled{};
  for (std::uint32_t k = 0; k < 4; ++k) scaled[k] = error("tet10", 0.3, 2u << k) * std::pow(2u << k, 4);
  const double logarithm = scaled[1] - scaled[0];
  EXPECT_GT(logarithm, 0.1 * scaled[3]) << "no singularity seen";
  EXPECT_NEAR((scaled[2] - scaled[1]) / logarithm, 1, 0.02);
  EXPECT_NEAR((scaled[3] - scaled[2]) / logarithm, 1, 0.02);
}

/// f_h/f − 1 of a bar that swings along its length, ν = 0, held at one end: f = √(E/ρ)/4L, a sine.
double axial_frequency_error(const std::string& element, std::uint32_t n) {
  const double L = 0.4, density = 1000;
  const Specimen bar = make_specimen("fem_linear", element, E, 0, kuhn_box({n, 1, 1}, Vec3(L, L / n, L / n)));
  const auto held = [](const Vec3& p, int c) { return c != 0 || p.x() < 1e-9; };
  VecX mode = VecX::Zero(bar.model->rest().size());
  for (Eigen::Index i = 0; i < mode.size(); i += 3) mode[i] = bar.model->rest()[i];
  const double exact = std::sqrt(E / density) / (4 * L);
  return lowest_frequency(*bar.model, density, held, std::move(mode)) / exact - 1;
}

TEST(Order, OfAFrequency) {
  for (const char* element : {"tet4", "tet10"}) {
    const double coarse = axial_frequency_error(element, 8), fine = axial_frequency_error(element, 16);
    EXPECT_NEAR(order(coarse, fine), 2, 0.1) << element;
    EXPECT_LT(fine, 0) << "a lumped mass slows waves down";
  }
}

}  // namespace
}  // namespace prosector
