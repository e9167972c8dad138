#pragma once
// A plot of rows: lines of what belongs together, over an even or a logarithmic axis.

#include <functional>
#include <string>
#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

/// An axis from one value to another, evenly or by ratios.
struct PlotAxis {
  double least, most;
  bool by_ratio;
  std::vector<double> ticks;
  /// Returns where a value lies, from 0 to 1; what is beyond an end lies at it.
  double share(double value) const;
};

struct PlotWords {
  std::string title, under, along, up;
};

/// Draws one line through the points that `x` and `y` give of the rows that have the same text under `key`.
Svg draw_lines(const std::vector<ReportRow>& rows, std::string_view key, const PlotAxis& across,
               const PlotAxis& up, const PlotWords& words, const std::function<double(const ReportRow&)>& x,
               const std::function<double(const ReportRow&)>& y);

}  // namespace prosector
