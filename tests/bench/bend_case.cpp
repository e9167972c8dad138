// The bending beam: a clamped beam of 0.4 × 0.1 × 0.1 m sags under its own weight, critically damped, and is
// measured when it has come to rest.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/bench/beam_piece.h"
#include "tests/bench/trade_case.h"

namespace prosector {
namespace {

constexpr double settle_s = 2;

struct Deflection {
  const char* model;
  double at_0_30, at_0_45;  // m, −u_y of the free face's centre, converged
};
/// What each law's continuum does, to about 0.02 %; converged over mesh refinement with quadratic elements.
constexpr Deflection continuum[] = {{"fem_linear", .13095, .12816},
                                    {"bullet_deformable_linear", .12275, .1206},
                                    {"fem_corotational", .12275, .1206},
                                    {"fem_neo_hookean_polynomial", .12322, .12103},
                                    {"fem_neo_hookean", .12308, .12087}};
/// What tissue does: the hyperelastic laws agree to 0.4 %. Models without a continuum of their own, and the
/// linear one, which has no business bending that far, are held against this.
constexpr Deflection tissue = {"fem_neo_hookean", .12308, .12087};

double of(const Deflection& row, double poisson_ratio) {
  return poisson_ratio < 0.4 ? row.at_0_30 : row.at_0_45;
}

TestPiece damped_beam(unsigned cells, double poisson_ratio) {
  TestPiece piece = beam_piece(cells, poisson_ratio);
  piece.damping_mass = 2 * 2 * std::numbers::pi * beam_first_frequency;  // critical for the first mode
  return piece;
}

ReportRow measure(Specimen& specimen, const TestPiece& piece, const std::string& model, Runner& runner) {
  const Eigen::Index tip = node_at(specimen.rest(), beam_tip());
  const double still = specimen.rest()[3 * tip + 1];
  const double rest_volume = volume(piece.mesh, specimen.rest());
  ReportRow row = ReportRow::object();
  if (!runner.run(settle_s, [](double) {})) return row;
  const VecX x = specimen.positions();
  const double sag = still - x[3 * tip + 1];
  row["deflection_m"] = sag;
  row["error_material"] = std::abs(sag / of(tissue, piece.poisson_ratio) - 1);
  const auto* own = std::find_if(std::begin(continuum), std::end(continuum),
                                 [&](const Deflection& d) { return model == d.model; });
  if (own != std::end(continuum)) row["error_continuum"] = std::abs(sag / of(*own, piece.poisson_ratio) - 1);
  row["volume_loss"] = 1 - volume(piece.mesh, x) / rest_volume;
  row["speed_left_m_per_s"] = specimen.velocities().lpNorm<Eigen::Infinity>();
  return row;
}

}  // namespace

const TradeCase& bend_case() {
  static const TradeCase row = {"bend",           "A beam bends under its own weight (ν = 0.3)",
                                "error_material", "error of the settled tip against tissue's continuum",
                                {8, 16, 24},      [](unsigned cells) { return damped_beam(cells, 0.3); },
                                measure,          {0, -9.81, 0}};
  return row;
}

const TradeCase& bend_incompressible_case() {
  static const TradeCase row = {"bend_incompressible",
                                "A nearly incompressible beam bends under its own weight (ν = 0.45)",
                                "error_material",
                                "error of the settled tip against tissue's continuum",
                                {8, 16, 24},
                                [](unsigned cells) { return damped_beam(cells, 0.45); },
                                measure,
                                {0, -9.81, 0}};
  return row;
}

}  // namespace prosector
