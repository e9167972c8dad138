#include "tests/bench/haptic_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace prosector {
namespace {

constexpr double from_left = 80, from_top = 70, width = 520, height = 380;

/// An axis from one value to another, evenly or by ratios.
struct Axis {
  double least, most;
  bool by_ratio;
  std::vector<double> ticks;
  double share(double value) const {
    const double v = std::clamp(value, least, most);
    return by_ratio ? std::log(v / least) / std::log(most / least) : (v - least) / (most - least);
  }
};

struct Words {
  std::string title, under, along, up;
};

/// Draws one line a scheme through the points that `x` and `y` give of its rows.
Svg draw(const std::vector<ReportRow>& rows, const Axis& across, const Axis& up, const Words& words,
         const std::function<double(const ReportRow&)>& x, const std::function<double(const ReportRow&)>& y) {
  Svg svg(from_left + width + 260, from_top + height + 70);
  const auto at = [&](double value, double other) {
    return std::pair(from_left + width * across.share(value), from_top + height * (1 - up.share(other)));
  };
  for (const double tick : across.ticks) {
    svg.line(at(tick, up.least).first, from_top, at(tick, up.least).first, from_top + height,
             {"#e2e2e2", 1, ""});
    svg.text(at(tick, up.least).first, from_top + height + 20, fmt::format("{:g}", tick), {13, "middle"});
  }
  for (const double tick : up.ticks) {
    svg.line(from_left, at(across.least, tick).second, from_left + width, at(across.least, tick).second,
             {"#e2e2e2", 1, ""});
    svg.text(from_left - 8, at(across.least, tick).second + 5, fmt::format("{:g}", tick), {13, "end"});
  }
  std::map<std::string, std::vector<std::pair<double, double>>> lines;
  std::vector<std::string> order;
  for (const ReportRow& row : rows) {
    const std::string scheme = setting(row, "scheme");
    if (!lines.contains(scheme)) order.push_back(scheme);
    lines[scheme].push_back(at(x(row), y(row)));
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::string& color = palette[i % palette.size()];
    svg.path(lines[order[i]], {color, i == 0 ? 3. : 1.6, ""});
    for (const auto& [px, py] : lines[order[i]]) svg.circle(px, py, i == 0 ? 4.5 : 3, color);
    const double line = from_top + 12 + 22 * static_cast<double>(i);
    svg.line(from_left + width + 16, line - 4, from_left + width + 32, line - 4,
             {color, i == 0 ? 3. : 1.6, ""});
    svg.text(from_left + width + 38, line, order[i], {12.5});
  }
  svg.rect(from_left, from_top, width, height, "none", "#555555");
  svg.text(from_left, 28, words.title, {18, "start", "#000000", true});
  svg.text(from_left, 50, words.under, {12, "start", "#555555"});
  svg.text(from_left + width / 2, from_top + height + 46, words.along, {14, "middle"});
  svg.text(24, from_top + height / 2, words.up, {14, "middle", "#222222", false, -90});
  return svg;
}

}  // namespace

Svg draw_stable_stiffness(const std::vector<ReportRow>& rows) {
  return draw(
      rows, {0, 200, false, {0, 20, 50, 100, 200}}, {30, 20000, true, {30, 100, 300, 1000, 3000, 10000}},
      {"The stiffest tissue that an arm shows stably", "a light hand; jitter 0 to 20 ms each way, 5 % lost",
       "round trip, ms", "N/m"},
      [](const ReportRow& row) { return 1e3 * figure(row, "round_trip"); },
      [](const ReportRow& row) { return figure(row, "stable_stiffness"); });
}

Svg draw_felt_stiffness(const std::vector<ReportRow>& rows) {
  return draw(
      rows, {30, 10000, true, {30, 100, 300, 1000, 3000, 10000}}, {0, 3, false, {0, 0.5, 1, 1.5, 2, 2.5, 3}},
      {"Stiffness as it is felt, over what it is",
       "a medium hand that swings twice a second; 100 ms round trip, jitter 0 to 20 ms, 5 % lost",
       "stiffness of the tissue, N/m", "felt over true"},
      [](const ReportRow& row) { return figure(row, "stiffness"); },
      [](const ReportRow& row) { return figure(row, "felt_2hz"); });
}

}  // namespace prosector
