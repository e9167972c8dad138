// The vibrating beam: released in the shape of its first bending mode, 4 mm at the tip, without gravity and
// damping. The continuum oscillates at beam_first_frequency with constant amplitude.

#include <cmath>
#include <numbers>

#include "server/calibration/rung.h"
#include "tests/bench/damped_cosine.h"
#include "tests/bench/first_mode.h"
#include "tests/bench/specimen_measures.h"
#include "tests/bench/trade_case.h"

namespace prosector {
namespace {

constexpr double amplitude = 0.004;  // m
constexpr double periods = 3;
constexpr double higher_modes_s = 0.15;  // s: frequency and decay are fitted to later times

/// Returns the first mode of the mesh, `amplitude` at the tip. The continuum's mode would also excite higher
/// modes of the mesh. Implicit Euler steps from rest act as inverse iterations: each keeps half of the first
/// mode and a thirtieth of the second. Specimens with more nodes than the mesh start in the continuum's mode.
VecX pure_mode(const TestPiece& piece, const VecX& rest, Eigen::Index tip) {
  VecX bent = in_first_mode(rest, amplitude);
  if (rest.size() != static_cast<Eigen::Index>(3 * piece.mesh.positions.size())) return bent;
  const auto filter = make_specimen({"fem_linear", "implicit_euler", "direct"}, piece);
  for (int i = 0; i < 4; ++i) {
    filter->set_motion(bent, VecX::Zero(rest.size()));
    filter->step(0.1, Vec3::Zero());
    const VecX moved = filter->positions() - rest;
    bent = rest + moved * (amplitude / swing_direction.dot(moved.segment<3>(tip)));
  }
  return bent;
}

ReportRow measure(Specimen& specimen, const TestPiece& piece, const std::string&, Runner& runner) {
  const VecX rest = specimen.rest();
  const Eigen::Index tip = 3 * node_at(rest, beam_tip());
  specimen.set_motion(pure_mode(piece, rest, tip), VecX::Zero(rest.size()));
  const double start = specimen.elastic_energy();
  std::vector<double> times, tips;
  double error = 0, reference = 0;
  constexpr double omega = 2 * std::numbers::pi * beam_first_frequency;
  const bool done = runner.run(periods / beam_first_frequency, [&](double t) {
    const double now = swing_direction.dot((specimen.positions() - rest).segment<3>(tip)),
                 right = amplitude * std::cos(omega * t);
    error += (now - right) * (now - right);
    reference += right * right;
    if (t < higher_modes_s) return;
    times.push_back(t);
    tips.push_back(now);
  });
  ReportRow row = ReportRow::object();
  if (!done) return row;
  const DampedCosine fit = fit_damped_cosine(times, tips, omega);
  row["error_dynamic"] = std::sqrt(error / reference);
  row["frequency_hz"] = fit.omega / (2 * std::numbers::pi);
  row["error_frequency"] = std::abs(fit.omega / omega - 1);
  row["amplitude_lost_per_period"] = 1 - std::exp(-fit.decay / beam_first_frequency);
  row["phase_lag_per_period_rad"] = 2 * std::numbers::pi * (1 - fit.omega / omega);
  row["energy_drift"] = (specimen.elastic_energy() + kinetic_energy(specimen)) / start - 1;
  return row;
}

}  // namespace

const TradeCase& swing_case() {
  static const TradeCase row = {"swing",
                                "A beam swings in its first mode (ν = 0.3)",
                                "error_dynamic",
                                "RMS error of the tip's path over three periods",
                                {8, 16},
                                [](unsigned cells) { return beam_piece(cells, 0.3); },
                                measure,
                                {0, 0, 0},
                                true};
  return row;
}

}  // namespace prosector
