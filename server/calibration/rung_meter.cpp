#include "server/calibration/rung_meter.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "server/calibration/beam_piece.h"
#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/rungs.h"

namespace prosector {
namespace {

constexpr int path_frames = 24;      // 0.4 s: down to the turning point and a little back
constexpr int settling_frames = 80;  // of position-based models
constexpr double long_step = 0.5;    // s: a step so long that inertia is negligible
constexpr int most_long_steps = 30;
constexpr double at_rest = 1e-7;  // m per long step: smaller motion counts as rest
const Vec3 gravity(0, -9.81, 0);

bool position_based(const Rung& rung) {
  return soft::find_row(soft::models(), "model", rung.model).position_based;
}

TestPiece beam(const RungTrial& trial, double damping_mass) {
  TestPiece piece = beam_piece(trial.cells, trial.poisson_ratio);
  piece.damping_mass = damping_mass;
  return piece;
}

/// Returns the mass damping (1/s) that damps the first mode critically, for trials in which only the settled
/// shape counts.
double critical() {
  return 2 * 2 * std::numbers::pi * beam_first_frequency;
}

/// Returns the mean sag (m) over the free face. The face stays flat to well within the accuracy of the
/// measurement.
double sag(const Specimen& specimen) {
  const VecX rest = specimen.rest(), x = specimen.positions();
  double sum = 0;
  int count = 0;
  for (Eigen::Index k = 0; k < rest.size(); k += 3) {
    if (rest[k] < beam_size[0] - 1e-9) continue;
    sum += rest[k + 1] - x[k + 1];
    ++count;
  }
  return sum / count;
}

Rung solved_to_the_end(Rung rung) {
  rung.solver = "multigrid";
  rung.newton_iterations = 20;
  rung.solver_iterations = 500;
  rung.solver_tolerance = 1e-6;
  return rung;
}

double settle(Specimen& specimen) {
  for (int i = 0; i < most_long_steps; ++i) {
    const VecX before = specimen.positions();
    specimen.step(long_step, gravity);
    if ((specimen.positions() - before).lpNorm<Eigen::Infinity>() < at_rest) break;
  }
  return sag(specimen);
}

}  // namespace

const RungMeter::Exact& RungMeter::exact(const RungTrial& trial) {
  const auto key = std::tuple(trial.rung.model, trial.rung.element, trial.poisson_ratio, trial.cells);
  const auto [at, is_new] = exact_.try_emplace(key);
  if (!is_new) return at->second;
  const Rung rung = solved_to_the_end(trial.rung);
  at->second.settled_sag = settle(*make_specimen(rung, beam(trial, critical())));
  const auto moving = make_specimen(rung, beam(trial, 1));
  const VecX rest = moving->rest();
  for (int i = 0; i < path_frames; ++i) {
    moving->step(frame_seconds, gravity);
    at->second.path.push_back(moving->positions() - rest);
  }
  return at->second;
}

RungFigures RungMeter::measure(const RungTrial& trial) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const bool own_steps = position_based(trial.rung);
  const Exact* right = own_steps ? nullptr : &exact(trial);
  const TestPiece piece = beam(trial, own_steps ? critical() : 1);
  const auto specimen = make_specimen(trial.rung, piece);
  const VecX rest = specimen->rest();
  RungFigures out;
  out.elements = static_cast<double>(piece.mesh.tets.size());
  std::vector<double> ms;
  double passed_ms = 0;
  double off = 0, moved = 0, not_as_described = 0;
  for (int i = 0; i < (own_steps ? settling_frames : path_frames); ++i) {
    const double begun = cpu_ms(), begun_wall = wall_ms();
    const StepFigures step = specimen->step(frame_seconds, gravity);
    ms.push_back(cpu_ms() - begun);
    passed_ms += wall_ms() - begun_wall;
    out.iterations += step.solver_iterations;
    not_as_described += step.reported;
    if (!right) continue;
    const VecX& exact = right->path[static_cast<std::size_t>(i)];
    off += (specimen->positions() - rest - exact).squaredNorm();
    moved += exact.squaredNorm();
  }
  const std::size_t frames = ms.size();
  out.iterations /= static_cast<double>(frames);
  out.share = std::min(1.0, std::accumulate(ms.begin(), ms.end(), 0.0) / passed_ms);
  out.ms = median(std::move(ms));
  out.settled_sag = right ? right->settled_sag : sag(*specimen);
  if (right) out.drift = std::sqrt(off / moved);
  // Frames that fell back on another rung count as wrong: their accuracy is the other rung's.
  out.drift = std::max(out.drift, not_as_described / static_cast<double>(frames));
  return out;
}

}  // namespace prosector
