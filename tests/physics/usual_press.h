#pragma once
// A ball that presses a layer of tissue whose description names its shape and material only, and slides.

#include <algorithm>
#include <cmath>

#include "tests/physics/under_ball.h"

namespace prosector::test {

inline const double usual_cell = SoftGeometry().cell;  // m

/// Returns a scene with a fixed ball of that radius (m) just above a layer of that height (m), 5 kPa, whose
/// underside is held. Elements, surface, model, contact and solver are a scene's defaults.
SceneDesc usual_layer(double height, double poisson_ratio, double radius);

/// Forces on a ball that is pressed into a layer, held, and moved sideways over one cell.
struct Slide {
  double force = 0;                     // N, when held
  double least = 0, most = 0, sum = 0;  // N, while sliding
  int ticks = 0;                        // of sliding
  double largest_change = 0;            // from tick to tick while sliding, relative

  double mean() const { return sum / ticks; }
};

/// Presses within 15 ticks, holds for 30, and slides at 2 cm/s at 60 ticks/s. `step(input)` makes a tick, and
/// `simulation` is what it steps.
template <class Step>
Slide press_and_slide(const Simulation& simulation, double radius, double depth, const Step& step) {
  constexpr int down = 15, held = 30;
  constexpr double each_tick = 0.02 / 60;  // m
  const auto to = [&](double x, double deep) {
    step(ball_at({x, radius - deep, 0.2 * usual_cell}));
    return pressing_force(simulation);
  };
  Slide out;
  for (int tick = 1; tick <= down + held; ++tick)
    out.force = to(0, depth * std::min(1.0, static_cast<double>(tick) / down));
  out.least = out.most = out.force;
  double last = out.force;
  for (double x = each_tick; x < usual_cell; x += each_tick) {
    const double now = to(x, depth);
    out.largest_change = std::max(out.largest_change, std::abs(now / last - 1));
    out.least = std::min(out.least, now);
    out.most = std::max(out.most, now);
    out.sum += now;
    ++out.ticks;
    last = now;
  }
  return out;
}

}  // namespace prosector::test
