// The bending beam: a clamped, critically damped beam of 0.4 × 0.1 × 0.1 m bends under its own weight. Its
// static deflection is measured.

#include <cmath>
#include <numbers>

#include "server/calibration/beam_piece.h"
#include "server/calibration/bend_reference.h"
#include "tests/bench/specimen_measures.h"
#include "tests/bench/trade_case.h"

namespace prosector {
namespace {

constexpr double settle_s = 2;

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
  row["error_material"] = std::abs(sag / tissue_sag(piece.poisson_ratio) - 1);
  // Bullet's linear elements rotate with the material, like a corotational law.
  const std::string law = model == "bullet_deformable_linear" ? "fem_corotational" : model;
  if (const auto own = continuum_sag(law, piece.poisson_ratio))
    row["error_continuum"] = std::abs(sag / *own - 1);
  row["volume_loss"] = 1 - volume(piece.mesh, x) / rest_volume;
  row["speed_left_m_per_s"] = specimen.velocities().lpNorm<Eigen::Infinity>();
  return row;
}

}  // namespace

const TradeCase& bend_case() {
  static const TradeCase row = {"bend",           "A beam bends under its own weight (ν = 0.3)",
                                "error_material", "static tip error against the continuum",
                                {8, 16, 24},      [](unsigned cells) { return damped_beam(cells, 0.3); },
                                measure,          {0, -9.81, 0}};
  return row;
}

const TradeCase& bend_incompressible_case() {
  static const TradeCase row = {"bend_incompressible",
                                "A nearly incompressible beam bends under its own weight (ν = 0.45)",
                                "error_material",
                                "static tip error against the continuum",
                                {8, 16, 24},
                                [](unsigned cells) { return damped_beam(cells, 0.45); },
                                measure,
                                {0, -9.81, 0}};
  return row;
}

}  // namespace prosector
