#include "tests/bench/estimate_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace prosector {
namespace {

constexpr double left = 80, top = 70, side = 460;
constexpr double least = 1e-3, most = 1;

double share_of(double error) {
  return std::log(std::clamp(error, least, most) / least) / std::log(most / least);
}
double x_of(double error) {
  return left + side * share_of(error);
}
double y_of(double error) {
  return top + side * (1 - share_of(error));
}

void draw_axes(Svg& svg) {
  for (const double error : {0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0}) {
    svg.line(x_of(error), top, x_of(error), top + side, {"#e2e2e2", 1, ""});
    svg.line(left, y_of(error), left + side, y_of(error), {"#e2e2e2", 1, ""});
    svg.text(x_of(error), top + side + 20, fmt::format("{:g} %", 100 * error), {13, "middle"});
    svg.text(left - 8, y_of(error) + 5, fmt::format("{:g} %", 100 * error), {13, "end"});
  }
  for (const double effectivity : {least_effectivity, 1.0, most_effectivity}) {
    const double from = least / std::min(1., effectivity), to = most / std::max(1., effectivity);
    svg.line(x_of(from), y_of(effectivity * from), x_of(to), y_of(effectivity * to),
             {"#555555", effectivity == 1 ? 1.5 : 1, effectivity == 1 ? "" : "5 4"});
  }
  svg.rect(left, top, side, side, "none", "#555555");
  svg.text(left, 28, "Estimated error against true error", {18, "start", "#000000", true});
  svg.text(left, 50, "dashed: 0.8 and 1.5 times the true error", {12, "start", "#555555"});
  svg.text(left + side / 2, top + side + 46, "true error of the work of the load", {14, "middle"});
  svg.text(26, top + side / 2, "estimate", {14, "middle", "#222222", false, -90});
}

}  // namespace

Svg draw_estimates(const std::vector<ReportRow>& rows) {
  Svg svg(left + side + 260, top + side + 70);
  draw_axes(svg);
  std::map<std::string, std::size_t> groups;
  for (const ReportRow& row : rows) {
    const bool press = setting(row, "act").starts_with("pressed");
    const std::string group =
        fmt::format("{}, {}", setting(row, "element"), press ? "pressed" : "under its weight, hanging");
    const std::size_t n = groups.try_emplace(group, groups.size()).first->second;
    svg.circle(x_of(std::abs(figure(row, "error_continuum"))), y_of(figure(row, "estimate")), 4,
               palette[n % palette.size()], "#ffffff");
  }
  for (const auto& [group, n] : groups) {
    const double line = top + 12 + 22 * static_cast<double>(n);
    svg.circle(left + side + 24, line - 4, 4.5, palette[n % palette.size()], "#ffffff");
    svg.text(left + side + 36, line, group, {12.5});
  }
  return svg;
}

}  // namespace prosector
