#pragma once
// Fractions formatted as percentages.

#include <fmt/format.h>

#include <string>

namespace prosector {

/// Returns a fraction as a percentage with two significant digits, never with an exponent, such as "4.2 %",
/// "35 %" or "140 %".
inline std::string percent_text(double share) {
  const double percent = 100 * share;
  if (percent > 0 && percent < 0.001) return "less than 0.001 %";
  return percent < 99.5 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

/// Returns whether a reported relative error is meaningful, that is, in 0 … 1. Below 0 no error was
/// estimated; above 1 the estimate is useless.
inline bool is_known_error(double share) {
  return share >= 0 && share <= 1;
}

}  // namespace prosector
