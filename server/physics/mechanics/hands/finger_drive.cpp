#include "server/physics/mechanics/hands/finger_drive.h"

#include <algorithm>
#include <cmath>

namespace prosector::hands {
namespace {

constexpr int bisections = 24;  // of an interval of length at most 2

/// Returns the drive's force after a step, N, positive towards larger flexion.
double push(double lag, const FingerDrive& drive) {
  return drive.max_force * std::clamp(lag / drive.lag, -1.0, 1.0);
}

/// Returns the resistance after a step, N, positive against larger flexion. It increases monotonically with
/// the step.
double resistance(double step, std::span<const Obstacle> obstacles) {
  double sum = 0;
  for (const Obstacle& o : obstacles) {
    const double now = o.stiffness * std::max(0.0, -o.gap);
    const double then = std::max(0.0, now + o.series * (o.way * step - std::max(0.0, o.gap)));
    sum += o.way < 0 ? -then : then;
  }
  return sum;
}

}  // namespace

double finger_step(double tracked, double flexion, double most, std::span<const Obstacle> obstacles,
                   const FingerDrive& drive) {
  const double wanted = std::clamp(tracked - flexion, -most, most);
  if (obstacles.empty()) return wanted;
  const auto surplus = [&](double step) {
    return push(tracked - flexion - step, drive) - resistance(step, obstacles);
  };
  double low = std::max(-most, -flexion), high = std::min(most, 1 - flexion);
  if (surplus(high) >= 0) return high;
  if (surplus(low) <= 0) return low;
  for (int i = 0; i < bisections; ++i) {
    const double middle = (low + high) / 2;
    (surplus(middle) > 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace prosector::hands
