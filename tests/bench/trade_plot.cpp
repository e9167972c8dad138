#include "tests/bench/trade_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "tests/bench/text_table.h"

namespace prosector {
namespace {

constexpr double left = 95, top = 70, plot_width = 640, plot_height = 500, bottom = 75, key_width = 690;

/// Logarithmic axis.
struct LogAxis {
  double low, high;  // log10
  double start, length;
  double at(double value) const {
    const double share = (std::log10(value) - low) / (high - low);
    return start + length * std::clamp(share, 0.0, 1.0);
  }
};

std::vector<TradePoint> drawable(const TradePlot& plot) {
  std::vector<TradePoint> points;
  for (TradePoint point : plot.points) {
    if (!(point.cost > 0) || !std::isfinite(point.cost) || !std::isfinite(point.error)) continue;
    point.error = std::clamp(std::abs(point.error), plot.error_floor, plot.error_ceiling);
    points.push_back(point);
  }
  return points;
}

LogAxis axis(const std::vector<TradePoint>& points, double TradePoint::*value, double start, double length) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const TradePoint& point : points) {
    low = std::min(low, point.*value);
    high = std::max(high, point.*value);
  }
  if (points.empty()) low = high = 1;
  low = std::floor(std::log10(low));
  return {low, std::max(std::ceil(std::log10(high)), low + 1), start, length};
}

std::string decade(double exponent) {
  const double value = std::pow(10, exponent);
  return exponent >= 0 ? fmt::format("{:.0f}", value)
                       : fmt::format("{:.{}f}", value, static_cast<int>(-exponent));
}

/// Draws the group's marker shape, so that groups differ in more than colour.
void mark(Svg& svg, std::size_t group, double x, double y, double r) {
  const std::string& color = palette[group % palette.size()];
  switch (group % 4) {
    case 0:
      svg.circle(x, y, r, color, "#ffffff");
      break;
    case 1:
      svg.polygon({{x, y - r - 1}, {x + r + 1, y + r}, {x - r - 1, y + r}}, color, "#ffffff");
      break;
    case 2:
      svg.rect(x - r, y - r, 2 * r, 2 * r, color, "#ffffff");
      break;
    default:
      svg.polygon({{x, y - r - 1}, {x + r + 1, y}, {x, y + r + 1}, {x - r - 1, y}}, color, "#ffffff");
  }
}

std::vector<std::string> groups_of(const std::vector<TradePoint>& points) {
  std::vector<std::string> groups;
  for (const TradePoint& point : points) {
    if (std::find(groups.begin(), groups.end(), point.group) == groups.end()) groups.push_back(point.group);
  }
  return groups;
}

void draw_axes(Svg& svg, const TradePlot& plot, const LogAxis& x, const LogAxis& y) {
  const double foot = top + plot_height;
  for (double e = x.low; e <= x.high; ++e) {
    const double at = x.at(std::pow(10, e));
    svg.line(at, top, at, foot, {"#e2e2e2", 1, ""});
    svg.text(at, foot + 20, decade(e), {13, "middle"});
  }
  for (double e = y.low; e <= y.high; ++e) {
    const double at = y.at(std::pow(10, e));
    svg.line(left, at, left + plot_width, at, {"#e2e2e2", 1, ""});
    svg.text(left - 8, at + 5, decade(e + 2) + " %", {13, "end"});
  }
  svg.rect(left, top, plot_width, plot_height, "none", "#555555");
  svg.text(left, 28, plot.title, {18, "start", "#000000", true});
  svg.text(left, 50, plot.subtitle, {12, "start", "#555555"});
  svg.text(left + plot_width / 2, foot + 48, plot.cost_label, {14, "middle"});
  svg.text(24, top + plot_height / 2, plot.error_label, {14, "middle", "#222222", false, -90});
}

/// Draws a Pareto front as a step line.
std::vector<std::pair<double, double>> staircase(const std::vector<TradePoint>& points,
                                                 const std::vector<std::size_t>& front, const LogAxis& x,
                                                 const LogAxis& y) {
  std::vector<std::pair<double, double>> path;
  for (const std::size_t i : front) {
    const double px = x.at(points[i].cost), py = y.at(points[i].error);
    if (!path.empty()) path.emplace_back(px, path.back().second);
    path.emplace_back(px, py);
  }
  if (!path.empty()) path.emplace_back(left + plot_width, path.back().second);
  return path;
}

/// Places a point's number below it to the left, farther down while it overlaps another number.
std::pair<double, double> place_number(double x, double y, std::vector<std::pair<double, double>>& taken) {
  constexpr double size = 16;
  std::pair<double, double> place(x - 11, y + 17);
  const auto covers = [&](const std::pair<double, double>& other) {
    return std::hypot(place.first - other.first, place.second - other.second) < size;
  };
  while (std::any_of(taken.begin(), taken.end(), covers)) place.second += size / 2;
  taken.push_back(place);
  return place;
}

void draw_number(Svg& svg, const std::string& number, double x, double y,
                 std::vector<std::pair<double, double>>& taken) {
  const auto [at_x, at_y] = place_number(x, y, taken);
  svg.line(x, y, at_x + 2, at_y - 4, {"#444444", 0.8, ""});
  svg.circle(at_x, at_y, 8, "#ffffff", "#444444");
  svg.text(at_x, at_y + 4, number, {10.5, "middle", "#000000", true});
}

const std::array<Stroke, 2> front_strokes = {Stroke{"#444444", 1.6, "6 3"}, Stroke{"#D55E00", 1.6, ""}};

/// Returns the indices of the front's points, cheapest first.
std::vector<std::size_t> front_of(const TradeFront& front, const std::vector<TradePoint>& points) {
  std::vector<std::size_t> among;
  std::vector<TradePoint> those;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& groups = front.groups;
    if (!groups.empty() && std::find(groups.begin(), groups.end(), points[i].group) == groups.end()) continue;
    among.push_back(i);
    those.push_back(points[i]);
  }
  std::vector<std::size_t> out = pareto_front(those);
  for (std::size_t& i : out) i = among[i];
  return out;
}

}  // namespace

std::vector<std::size_t> pareto_front(const std::vector<TradePoint>& points) {
  std::vector<std::size_t> order(points.size()), front;
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(points[a].cost, points[a].error) < std::pair(points[b].cost, points[b].error);
  });
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (points[i].error >= least) continue;
    least = points[i].error;
    front.push_back(i);
  }
  return front;
}

Svg draw(const TradePlot& plot) {
  const std::vector<TradePoint> points = drawable(plot);
  const std::vector<std::string> groups = groups_of(points);
  std::vector<std::vector<std::size_t>> fronts;
  std::size_t told = 0;
  for (const TradeFront& front : plot.fronts) told += fronts.emplace_back(front_of(front, points)).size();
  const double key_height = 24 + 18 * static_cast<double>(groups.size()) +
                            48 * static_cast<double>(fronts.size()) + 36 * static_cast<double>(told);
  const double height = std::max(top + plot_height + bottom, top + key_height + 20);
  Svg svg(left + plot_width + 30 + key_width, height);
  const LogAxis x = axis(points, &TradePoint::cost, left, plot_width);
  const LogAxis y = axis(points, &TradePoint::error, top + plot_height, -plot_height);
  draw_axes(svg, plot, x, y);
  for (std::size_t f = 0; f < fronts.size(); ++f)
    svg.path(staircase(points, fronts[f], x, y), front_strokes[f % front_strokes.size()]);

  const double key = left + plot_width + 30;
  double line = top + 6;
  for (std::size_t g = 0; g < groups.size(); ++g, line += 18) {
    mark(svg, g, key + 8, line - 4, 5);
    svg.text(key + 22, line, groups[g], {13});
    for (const TradePoint& point : points) {
      if (point.group == groups[g]) mark(svg, g, x.at(point.cost), y.at(point.error), 4.5);
    }
  }
  std::vector<std::pair<double, double>> taken;
  std::map<std::size_t, std::size_t> numbers;  // number of each point
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    line += 14;
    svg.line(key, line - 4, key + 30, line - 4, front_strokes[f % front_strokes.size()]);
    svg.text(key + 36, line, plot.fronts[f].title, {12.5, "start", "#000000", true});
    for (const std::size_t i : fronts[f]) {
      const TradePoint& point = points[i];
      const auto [at, is_new] = numbers.try_emplace(i, numbers.size() + 1);
      const std::string number = std::to_string(at->second);
      if (is_new) draw_number(svg, number, x.at(point.cost), y.at(point.error), taken);
      line += 20;
      svg.text(key, line, fmt::format("{}  {}", number, point.label), {12});
      line += 16;
      svg.text(key + 16, line,
               fmt::format("{} %  at  {} ms", three_digits(100 * point.error), three_digits(point.cost)),
               {11.5, "start", "#555555"});
    }
    line += 20;
  }
  return svg;
}

}  // namespace prosector
