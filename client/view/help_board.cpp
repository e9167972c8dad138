#include "client/view/help_board.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "client/view/overlay_frame.h"

namespace prosector {
namespace {

constexpr double board_margin = 8, board_gap = 8;                // points
constexpr double board_letters = 13, least_board_letters = 3.5;  // points, em heights

/// Returns the first line of the second block: the heading nearest to the middle, if one is near.
std::size_t middle_of(const std::vector<std::string>& lines) {
  const double half = 0.5 * static_cast<double>(lines.size());
  const auto off = [&](std::size_t k) { return std::abs(static_cast<double>(k) - half); };
  auto best = static_cast<std::size_t>(std::ceil(half));
  double least = half;
  for (std::size_t k = 1; k < lines.size(); ++k)
    if (lines[k].find('\t') == std::string::npos && off(k) < std::min(least, 0.4 * half)) {
      best = k;
      least = off(k);
    }
  return best;
}

}  // namespace

void add_help(DrawList& list, const std::string& help) {
  std::vector<std::string> lines;
  std::istringstream in(help);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  const OverlayFrame frame(list);
  const double width = 0.5 * (frame.width - 2 * board_margin - board_gap);
  const std::size_t middle = middle_of(lines);
  for (const bool right : {false, true}) {
    std::string text;
    for (std::size_t k = right ? middle : 0; k < (right ? lines.size() : middle); ++k)
      text += (text.empty() ? "" : "\n") + lines[k];
    if (text.empty()) continue;
    list.texts.push_back({.text = std::move(text),
                          .at = {board_margin + (right ? width + board_gap : 0), board_margin, 0},
                          .height = board_letters,
                          .wrap = width,
                          .least_height = least_board_letters,
                          .tallest = frame.height - 2 * board_margin,
                          .ground = TextGround::framed});
  }
}

}  // namespace prosector
