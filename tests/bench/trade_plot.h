#pragma once
// Error against cost, log–log, with the Pareto front: what a person chooses from.

#include <string>
#include <vector>

#include "tests/bench/svg.h"

namespace prosector {

/// Errors below it are one as good as another.
inline constexpr double negligible_error = 1e-5;

struct TradePoint {
  double cost = 0, error = 0;
  std::string group;  // colour and mark: see the legend
  std::string label;  // told of points on the front
};

/// An edge of what can be had.
struct TradeFront {
  std::string title;
  std::vector<std::string> groups;  // whose points; empty: all
};

struct TradePlot {
  std::string title, subtitle;
  std::string cost_label, error_label;
  /// Errors outside are drawn on the edge: below the floor nothing differs, above the ceiling all is lost.
  double error_floor = negligible_error, error_ceiling = 10;
  std::vector<TradeFront> fronts = {{"The front: nothing is both cheaper and better", {}}};
  std::vector<TradePoint> points;  // those without a finite positive cost and a finite error are left out
};

/// Indices of the points that no other one beats in cost and error, cheapest first.
std::vector<std::size_t> pareto_front(const std::vector<TradePoint>& points);

/// Errors are fractions and drawn as per cent.
Svg draw(const TradePlot& plot);

}  // namespace prosector
