#pragma once
// Shares as people read them.

#include <fmt/format.h>

#include <string>

namespace prosector {

/// Returns a share as a percentage of two digits, never with an exponent: "4.2 %", "35 %", "140 %".
inline std::string percent_text(double share) {
  const double percent = 100 * share;
  if (percent > 0 && percent < 0.001) return "less than 0.001 %";
  return percent < 99.5 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

/// Tells whether a reported relative error says anything: below 0 none was estimated, above 1 the estimate
/// is useless.
inline bool is_known_error(double share) {
  return share >= 0 && share <= 1;
}

}  // namespace prosector
