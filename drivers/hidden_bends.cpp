#include "drivers/hidden_bends.h"

#include <algorithm>

#include "drivers/device.h"

namespace prosector {
namespace {

// By pictures of our own hand: an open finger is seen less bent than the first, a closed one more than the
// second.
constexpr double seen_open = 0.42, seen_closed = 0.5;
// A fist from behind: its fingers are seen half open, and alike. An open finger beside closed ones is not.
constexpr double fist_seen = 0.43, fist_spread = 0.15;
constexpr double thumb_seen_open = 0.28, thumb_closes_at = 0.7;

/// Returns how far x is from a to b, put between c and d.
double between(double x, double a, double b, double c, double d) {
  return c + (d - c) * (x - a) / (b - a);
}

double thumb_bend(double seen, double open_below) {
  return seen < thumb_seen_open ? between(seen, 0, thumb_seen_open, 0, open_below)
                                : between(seen, thumb_seen_open, thumb_closes_at, open_below, 1);
}

double finger_bend(double seen, double open_below, double closed_above) {
  if (seen < seen_open) return between(seen, 0, seen_open, 0, open_below);
  if (seen < seen_closed) return between(seen, seen_open, seen_closed, open_below, closed_above);
  return between(seen, seen_closed, 1, closed_above, 1);
}

bool seems_a_fist(const std::array<double, fingers>& seen) {
  const auto [least, most] = std::minmax_element(seen.begin() + 1, seen.end());
  return *least >= fist_seen && *most - *least <= fist_spread;
}

}  // namespace

std::array<double, fingers> bends_for_gestures(const std::array<double, fingers>& seen) {
  static const DeviceConfig usual;  // what thresholds are where nobody set them
  const double closed = (1 + usual.closed_above) / 2;
  const bool fist = seems_a_fist(seen);
  std::array<double, fingers> out{};
  for (std::size_t f = 0; f < fingers; ++f) {
    const double bend = f == 0 ? thumb_bend(seen[f], usual.open_below)
                               : finger_bend(seen[f], usual.open_below, usual.closed_above);
    out[f] = std::clamp(fist && f > 0 ? std::max(bend, closed) : bend, 0.0, 1.0);
  }
  return out;
}

}  // namespace prosector
