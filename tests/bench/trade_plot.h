#pragma once
// Log–log plot of error against cost, with Pareto fronts.

#include <string>
#include <vector>

#include "tests/bench/svg.h"

namespace prosector {

/// Errors below this are treated as equal (fraction).
inline constexpr double negligible_error = 1e-5;

struct TradePoint {
  double cost = 0, error = 0;
  std::string group;  // determines colour and marker; listed in the legend
  std::string label;  // printed for points on a front
};

/// A Pareto front of some groups.
struct TradeFront {
  std::string title;
  std::vector<std::string> groups;  // groups that it covers; empty: all
};

struct TradePlot {
  std::string title, subtitle;
  std::string cost_label, error_label;
  /// Errors outside this range are drawn on the edge of the plot (fractions).
  double error_floor = negligible_error, error_ceiling = 10;
  std::vector<TradeFront> fronts = {{"Pareto front: no other run is cheaper and more accurate", {}}};
  std::vector<TradePoint> points;  // points without finite positive cost and finite error are omitted
};

/// Returns the indices of the Pareto-optimal points in cost and error, cheapest first.
std::vector<std::size_t> pareto_front(const std::vector<TradePoint>& points);

/// Draws the plot. Errors are given as fractions and labelled in per cent.
Svg draw(const TradePlot& plot);

}  // namespace prosector
