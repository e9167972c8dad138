#include "tests/bench/verdict_map.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr double cell_width = 26, cell_height = 22, margin = 20, character = 6.7;
const char* const fills[] = {"#9ADBC5", "#F5E58A", "#A9D3F0", "#E8704A"};
const char* const letters[] = {"s", "d", "r", "F"};

double longest(const std::vector<std::string>& words) {
  std::size_t length = 0;
  for (const std::string& word : words) length = std::max(length, word.size());
  return character * static_cast<double>(length);
}

void draw_cell(Svg& svg, double x, double y, const VerdictCell& cell) {
  const auto verdict = static_cast<std::size_t>(cell.verdict);
  svg.rect(x, y, cell_width, cell_height, fills[verdict], "#ffffff");
  svg.text(x + cell_width / 2, y + 15, letters[verdict],
           {12, "middle", "#222222", cell.verdict == Verdict::fails});
  if (!cell.met_deadline)
    svg.polygon({{x + cell_width - 8, y}, {x + cell_width, y}, {x + cell_width, y + 8}}, "#333333");
}

void draw_legend(Svg& svg, double x, double y) {
  for (std::size_t v = 0; v < verdict_names.size(); ++v, x += 110) {
    draw_cell(svg, x, y, {static_cast<Verdict>(v), true});
    svg.text(x + cell_width + 6, y + 15, verdict_names[v], {12});
  }
  svg.polygon({{x, y + 4}, {x + 8, y + 4}, {x + 8, y + 12}}, "#333333");
  svg.text(x + 14, y + 15, "median frame slower than real time", {12});
}

}  // namespace

Svg draw(const VerdictMap& map) {
  const double head = 70 + 0.72 * longest(map.extremes), left = margin + longest(map.rungs) + 10;
  const double across = static_cast<double>(map.extremes.size()) * cell_width;
  const double down = static_cast<double>(map.rungs.size()) * cell_height;
  Svg svg(std::max(left + across + 0.72 * longest(map.extremes) + margin, 900.0), head + down + 60);
  svg.text(margin, 28, map.title, {18, "start", "#000000", true});
  svg.text(margin, 48, map.subtitle, {12, "start", "#555555"});
  for (std::size_t c = 0; c < map.extremes.size(); ++c) {
    const double x = left + cell_width * (static_cast<double>(c) + 0.6);
    svg.text(x, head - 6, map.extremes[c], {11.5, "start", "#222222", false, -45});
  }
  for (std::size_t r = 0; r < map.rungs.size(); ++r) {
    const double y = head + cell_height * static_cast<double>(r);
    svg.text(left - 8, y + 15, map.rungs[r], {12, "end"});
    for (std::size_t c = 0; c < map.extremes.size(); ++c) {
      const auto& cell = map.cells[r][c];
      if (cell) draw_cell(svg, left + cell_width * static_cast<double>(c), y, *cell);
    }
  }
  draw_legend(svg, margin, head + down + 18);
  return svg;
}

}  // namespace prosector
