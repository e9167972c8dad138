// The heavy block: a cube of soft, nearly incompressible tissue stands on its glued foot under twice its own
// weight. It should sink and bulge, and preserve its volume.

#include <cmath>

#include "tests/bench/specimen_measures.h"
#include "tests/bench/trade_case.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

constexpr double settle_s = 1.5;
constexpr double side = 0.1;  // m
/// Continuum limit of the top centre's downward displacement with fem_neo_hookean, m. Quadratic elements give
/// 0.015200, 0.015022 and 0.014977 with 4, 6 and 8 cells per side, extrapolated to within 1e-5.
constexpr double right_sinking = 0.01494;

void judge(ReportRow& row) {
  const double sinking = figure(row, "deflection_m");
  if (std::isfinite(sinking)) row["error_material"] = std::abs(sinking / right_sinking - 1);
}

ReportRow measure(Specimen& specimen, const TestPiece& piece, const std::string&, Runner& runner) {
  const VecX rest = specimen.rest();
  const Eigen::Index top = 3 * node_at(rest, {side / 2, side, side / 2}) + 1;
  const double rest_volume = volume(piece.mesh, rest);
  ReportRow row = ReportRow::object();
  if (!runner.run(settle_s, [](double) {})) return row;
  const VecX x = specimen.positions();
  row["deflection_m"] = rest[top] - x[top];
  row["volume_loss"] = 1 - volume(piece.mesh, x) / rest_volume;
  return row;
}

}  // namespace

const TradeCase& heavy_case() {
  static const TradeCase row = {"heavy",
                                "A nearly incompressible cube sinks under twice its weight (ν = 0.49)",
                                "error_material",
                                "error of the top's displacement",
                                {4, 8, 12},
                                [](unsigned cells) {
                                  TestPiece piece;
                                  piece.mesh = kuhn_box({cells, cells, cells}, Vec3(side, side, side));
                                  piece.youngs_modulus = 5000;
                                  piece.poisson_ratio = 0.49;
                                  piece.damping_mass = 30;
                                  piece.clamped_axis = 1;
                                  return piece;
                                },
                                measure,
                                {0, -2 * 9.81, 0},
                                false,
                                judge};
  return row;
}

}  // namespace prosector
