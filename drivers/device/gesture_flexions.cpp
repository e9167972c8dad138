#include "drivers/device/gesture_flexions.h"

#include <algorithm>

#include "drivers/device/gesture.h"

namespace prosector {
namespace {

// Measured on images of the hand model: open fingers are detected below seen_open, closed fingers above
// seen_closed.
constexpr double seen_open = 0.42, seen_closed = 0.5;
// A fist from behind is detected as four half-open fingers with equal flexion, unlike an open finger next to
// closed ones.
constexpr double fist_min_flexion = 0.43, fist_max_spread = 0.15;
constexpr double thumb_seen_open = 0.28, thumb_closed_flexion = 0.7;

/// Maps x linearly from the range [a, b] to [c, d].
double between(double x, double a, double b, double c, double d) {
  return c + (d - c) * (x - a) / (b - a);
}

double thumb_bend(double seen, double open_below) {
  return seen < thumb_seen_open ? between(seen, 0, thumb_seen_open, 0, open_below)
                                : between(seen, thumb_seen_open, thumb_closed_flexion, open_below, 1);
}

double finger_bend(double seen, double open_below, double closed_above) {
  if (seen < seen_open) return between(seen, 0, seen_open, 0, open_below);
  if (seen < seen_closed) return between(seen, seen_open, seen_closed, open_below, closed_above);
  return between(seen, seen_closed, 1, closed_above, 1);
}

bool looks_like_fist(const std::array<double, fingers>& seen) {
  const auto [least, most] = std::minmax_element(seen.begin() + 1, seen.end());
  return *least >= fist_min_flexion && *most - *least <= fist_max_spread;
}

}  // namespace

std::array<double, fingers> gesture_flexions(const std::array<double, fingers>& seen) {
  constexpr GestureThresholds usual;
  const double closed = (1 + usual.closed_above) / 2;
  const bool fist = looks_like_fist(seen);
  std::array<double, fingers> out{};
  for (std::size_t f = 0; f < fingers; ++f) {
    const double bend = f == 0 ? thumb_bend(seen[f], usual.open_below)
                               : finger_bend(seen[f], usual.open_below, usual.closed_above);
    out[f] = std::clamp(fist && f > 0 ? std::max(bend, closed) : bend, 0.0, 1.0);
  }
  return out;
}

}  // namespace prosector
