#include "tests/bench/contact_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/bench/contact_run.h"

namespace prosector {
namespace {

constexpr double left = 80, top = 70, width = 560, height = 380;
constexpr double least_error = 0.002, most_error = 0.5, goal = 0.05;
constexpr double fewest_cells = 0.4, most_cells = 2.5;

double x_of(double cells) {
  return left + width * std::log(cells / fewest_cells) / std::log(most_cells / fewest_cells);
}
double y_of(double error) {
  const double e = std::clamp(std::abs(error), least_error, most_error);
  return top + height * std::log(most_error / e) / std::log(most_error / least_error);
}

void draw_axes(Svg& svg) {
  for (const double cells : {0.5, 1.0, 2.0}) {
    svg.line(x_of(cells), top, x_of(cells), top + height, {"#e2e2e2", 1, ""});
    svg.text(x_of(cells), top + height + 20, fmt::format("{}", cells), {13, "middle"});
  }
  for (const double error : {0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5}) {
    svg.line(left, y_of(error), left + width, y_of(error), {"#e2e2e2", 1, ""});
    svg.text(left - 8, y_of(error) + 5, fmt::format("{} %", 100 * error), {13, "end"});
  }
  svg.line(left, y_of(goal), left + width, y_of(goal), {"#333333", 1.5, "6 3"});
  svg.text(left + width - 4, y_of(goal) - 6, "goal", {12, "end"});
  svg.rect(left, top, width, height, "none", "#555555");
  svg.text(left, 28, "Force error of a ball pressed into a bonded layer", {18, "start", "#000000", true});
  svg.text(left, 50, "relative to the finite-layer table", {12, "start", "#555555"});
  svg.text(left + width / 2, top + height + 46, "cells per contact radius", {14, "middle"});
}

}  // namespace

Svg draw_hertz(const std::vector<ReportRow>& rows) {
  std::map<std::string, std::vector<std::pair<double, double>>> lines;
  for (const ReportRow& row : rows) {
    if (setting(row, "case") != "hertz" || figure(row, "contact_stiffness") != hertz_contact_stiffness ||
        figure(row, "radius_m") > 0.01)
      continue;
    const std::string name =
        fmt::format("{}, layer {:.0f} mm, {:.0f} mm deep, ν = {}", setting(row, "element"),
                    1e3 * figure(row, "layer_m"), 1e3 * figure(row, "depth_m"), figure(row, "poisson_ratio"));
    lines[name].emplace_back(figure(row, "cells_per_contact_radius"), figure(row, "measured") - 1);
  }
  Svg svg(left + width + 320, top + height + 70);
  draw_axes(svg);
  std::size_t n = 0;
  for (const auto& [name, points] : lines) {
    const std::string& color = palette[n % palette.size()];
    std::vector<std::pair<double, double>> path;
    for (const auto& [cells, error] : points) {
      path.emplace_back(x_of(cells), y_of(error));
      svg.circle(path.back().first, path.back().second, 4, color, "#ffffff");
    }
    const Stroke stroke{color, 1.6, name.starts_with("tet4") ? "4 3" : ""};
    svg.path(path, stroke);
    const double line = top + 12 + 20 * static_cast<double>(n++);
    svg.line(left + width + 14, line - 4, left + width + 44, line - 4, stroke);
    svg.circle(left + width + 29, line - 4, 4.5, color, "#ffffff");
    svg.text(left + width + 52, line, name, {12.5});
  }
  return svg;
}

}  // namespace prosector
