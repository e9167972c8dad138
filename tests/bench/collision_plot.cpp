#include "tests/bench/collision_plot.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/text_table.h"

namespace prosector {
namespace {

constexpr double top = 70, left = 80, side = 380, gap = 190, foot = 60;

struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;  // x, y
  bool line = true;
};

/// A square plot with logarithmic axes; the y axis is linear in per cent for shares.
struct Panel {
  std::string title, x_label, y_label;
  bool y_is_share = false;
  std::vector<Series> series;
};

struct Axis {
  double low, high;
  bool log;
  double share(double value) const {
    const double at = log ? std::log10(value) : value;
    return std::clamp((at - low) / (high - low), 0.0, 1.0);
  }
};

Axis axis(const Panel& panel, bool of_x) {
  if (!of_x && panel.y_is_share) return {0, 1, false};
  double low = 1e300, high = -1e300;
  for (const Series& s : panel.series)
    for (const auto& [x, y] : s.points) {
      low = std::min(low, std::log10(of_x ? x : y));
      high = std::max(high, std::log10(of_x ? x : y));
    }
  if (low > high) low = high = 0;
  low = std::floor(low);
  return {low, std::max(std::ceil(high), low + 1), true};
}

void draw(Svg& svg, const Panel& panel, double x0) {
  const Axis ax = axis(panel, true), ay = axis(panel, false);
  const auto px = [&](double x) { return x0 + side * ax.share(x); };
  const auto py = [&](double y) { return top + side * (1 - ay.share(y)); };
  svg.text(x0, top - 18, panel.title, {.size = 15, .bold = true});
  for (double e = ax.low; e <= ax.high; ++e) {
    svg.line(px(std::pow(10, e)), top, px(std::pow(10, e)), top + side, {"#dddddd", 1, ""});
    svg.text(px(std::pow(10, e)), top + side + 18, three_digits(std::pow(10, e)),
             {.size = 12, .anchor = "middle"});
  }
  for (double e = ay.low; e <= ay.high + 1e-9; e += ay.log ? 1 : 0.25) {
    const double value = ay.log ? std::pow(10, e) : e;
    svg.line(x0, py(value), x0 + side, py(value), {"#dddddd", 1, ""});
    svg.text(x0 - 6, py(value) + 4, ay.log ? three_digits(value) : three_digits(100 * value) + " %",
             {.size = 12, .anchor = "end"});
  }
  svg.text(x0 + side / 2, top + side + 40, panel.x_label, {.anchor = "middle"});
  svg.text(x0 - 58, top + side / 2, panel.y_label, {.anchor = "middle", .turn = -90});
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const Series& s = panel.series[i];
    const std::string& color = palette[i % palette.size()];
    std::vector<std::pair<double, double>> path;
    for (const auto& [x, y] : s.points) {
      path.emplace_back(px(x), py(y));
      svg.circle(px(x), py(y), 4, color, "#ffffff");
    }
    if (s.line && path.size() > 1) svg.path(path, {color, 2, ""});
    svg.circle(x0 + side + 14, top + 16 + 18 * static_cast<double>(i), 4, color);
    svg.text(x0 + side + 24, top + 20 + 18 * static_cast<double>(i), s.name, {.size = 12});
  }
}

Series& series(Panel& panel, const std::string& name) {
  for (Series& s : panel.series)
    if (s.name == name) return s;
  return panel.series.emplace_back(Series{name, {}, true});
}

void add(Panel& panel, const std::string& name, double x, double y) {
  const bool fits = x > 0 && std::isfinite(x) && std::isfinite(y) && (y > 0 || panel.y_is_share);
  if (fits) series(panel, name).points.emplace_back(x, y);
}

}  // namespace

Svg draw_collision(const std::vector<ReportRow>& rows) {
  Panel wrong{"False hits of rigid pairs, by shape", "µs per pair", "share of separated pairs", true, {}};
  Panel bodies{"Scenes of moving bodies", "bodies", "ms per tick", false, {}};
  Panel surfaces{"Two soft surfaces", "triangles per surface", "ms", false, {}};
  for (const ReportRow& row : rows) {
    const std::string kind = setting(row, "case"), fidelity = setting(row, "fidelity");
    if (kind == "pairs") add(wrong, fidelity, figure(row, "us_per_pair"), figure(row, "false_hits"));
    if (kind == "bodies") add(bodies, fidelity, figure(row, "bodies"), figure(row, "ms_scene"));
    if (kind == "surface")
      for (const auto& [key, name] : {std::pair{"ms_build", "build"},
                                      {"ms_refit", "refit"},
                                      {"ms_apart", "nearly touching"},
                                      {"ms_crossing", "10 % overlap"},
                                      {"ms_self", "self-collision"}})
        add(surfaces, name, figure(row, "triangles"), figure(row, key));
  }
  for (Series& s : wrong.series) s.line = false;
  Svg svg(left + 3 * (side + gap) - 80, top + side + foot);
  svg.text(left, 26, "Collision: cost and errors of each fidelity; one thread, CPU time",
           {.size = 17, .bold = true});
  draw(svg, wrong, left);
  draw(svg, bodies, left + side + gap);
  draw(svg, surfaces, left + 2 * (side + gap));
  return svg;
}

}  // namespace prosector
