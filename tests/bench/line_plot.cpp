#include "tests/bench/line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace prosector {
namespace {

constexpr double plot_left = 80, plot_top = 70, plot_width = 520, plot_height = 380;  // pixels

}  // namespace

double PlotAxis::share(double value) const {
  const double v = std::clamp(value, least, most);
  return by_ratio ? std::log(v / least) / std::log(most / least) : (v - least) / (most - least);
}

Svg draw_lines(const std::vector<ReportRow>& rows, std::string_view key, const PlotAxis& across,
               const PlotAxis& up, const PlotWords& words, const std::function<double(const ReportRow&)>& x,
               const std::function<double(const ReportRow&)>& y) {
  Svg svg(plot_left + plot_width + 260, plot_top + plot_height + 70);
  const auto at = [&](double value, double other) {
    return std::pair(plot_left + plot_width * across.share(value),
                     plot_top + plot_height * (1 - up.share(other)));
  };
  for (const double tick : across.ticks) {
    svg.line(at(tick, up.least).first, plot_top, at(tick, up.least).first, plot_top + plot_height,
             {"#e2e2e2", 1, ""});
    svg.text(at(tick, up.least).first, plot_top + plot_height + 20, fmt::format("{:g}", tick),
             {13, "middle"});
  }
  for (const double tick : up.ticks) {
    svg.line(plot_left, at(across.least, tick).second, plot_left + plot_width, at(across.least, tick).second,
             {"#e2e2e2", 1, ""});
    svg.text(plot_left - 8, at(across.least, tick).second + 5, fmt::format("{:g}", tick), {13, "end"});
  }
  std::map<std::string, std::vector<std::pair<double, double>>> lines;
  std::vector<std::string> order;
  for (const ReportRow& row : rows) {
    const std::string scheme = setting(row, key);
    if (!lines.contains(scheme)) order.push_back(scheme);
    lines[scheme].push_back(at(x(row), y(row)));
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::string& color = palette[i % palette.size()];
    svg.path(lines[order[i]], {color, i == 0 ? 3. : 1.6, ""});
    for (const auto& [px, py] : lines[order[i]]) svg.circle(px, py, i == 0 ? 4.5 : 3, color);
    const double line = plot_top + 12 + 22 * static_cast<double>(i);
    svg.line(plot_left + plot_width + 16, line - 4, plot_left + plot_width + 32, line - 4,
             {color, i == 0 ? 3. : 1.6, ""});
    svg.text(plot_left + plot_width + 38, line, order[i], {12.5});
  }
  svg.rect(plot_left, plot_top, plot_width, plot_height, "none", "#555555");
  svg.text(plot_left, 28, words.title, {18, "start", "#000000", true});
  svg.text(plot_left, 50, words.under, {12, "start", "#555555"});
  svg.text(plot_left + plot_width / 2, plot_top + plot_height + 46, words.along, {14, "middle"});
  svg.text(24, plot_top + plot_height / 2, words.up, {14, "middle", "#222222", false, -90});
  return svg;
}

}  // namespace prosector
