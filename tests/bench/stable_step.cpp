#include "tests/bench/stable_step.h"

#include <cmath>
#include <numbers>

#include "common/error.h"
#include "tests/bench/first_mode.h"

namespace prosector {
namespace {

constexpr double smallest_step = 2e-5;  // s
constexpr double amplitude = 0.004;     // m
constexpr int steps = 40;

bool is_stable(Specimen& beam, double dt) {
  const VecX rest = beam.rest(), bent = in_first_mode(rest, amplitude);
  beam.set_motion(bent, VecX::Zero(rest.size()));
  const double energy = beam.elastic_energy(), reach = (bent - rest).lpNorm<Eigen::Infinity>();
  for (int i = 0; i < steps; ++i) {
    if (beam.step(dt, Vec3::Zero()).reported) return false;
    if (!((beam.positions() - rest).lpNorm<Eigen::Infinity>() <= 2 * reach)) return false;
    if (beam.elastic_energy() + kinetic_energy(beam) > 1.01 * energy) return false;
  }
  return true;
}

}  // namespace

double largest_stable_step(const std::function<std::unique_ptr<Specimen>(const TestPiece&)>& make) {
  try {
    const auto beam = make(beam_piece(8, 0.3));
    double stable = 0;
    for (double dt = smallest_step; dt < largest_step_tried; dt *= std::numbers::sqrt2) {
      if (!is_stable(*beam, dt)) return stable;
      stable = dt;
    }
    return is_stable(*beam, largest_step_tried) ? largest_step_tried : stable;
  } catch (const InputError&) {
    return 0;
  }
}

}  // namespace prosector
