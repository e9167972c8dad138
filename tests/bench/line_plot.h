#pragma once
// Line plot of report rows, with linear or logarithmic axes.

#include <functional>
#include <string>
#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

/// Range of an axis, linear or logarithmic.
struct PlotAxis {
  double least, most;
  bool by_ratio;
  std::vector<double> ticks;
  /// Returns the position of a value on the axis, clamped to 0 … 1.
  double share(double value) const;
};

struct PlotWords {
  std::string title, under, along, up;
};

/// Draws one line per text under `key`, through the points (`x`, `y`) of the rows with that text.
Svg draw_lines(const std::vector<ReportRow>& rows, std::string_view key, const PlotAxis& across,
               const PlotAxis& up, const PlotWords& words, const std::function<double(const ReportRow&)>& x,
               const std::function<double(const ReportRow&)>& y);

}  // namespace prosector
