#pragma once
// Laid-out text, independent of its size. Lengths are in em; multiply by the text's size to get pixels,
// points or metres.

#include <cstdint>
#include <string>
#include <vector>

namespace prosector {

/// Heights of a line above and below its baseline, em. They are the same in every script, so that a text's
/// height depends only on its number of lines.
inline constexpr double line_ascent = 0.93, line_descent = 0.24;  // above and below the baseline
inline constexpr double line_spacing = 1.3;                       // from a baseline to the next

/// Returns the height of a block with this number of lines, em.
constexpr double height_of_lines(std::size_t lines) {
  return lines == 0 ? 0 : line_ascent + line_descent + line_spacing * static_cast<double>(lines - 1);
}

struct PlacedGlyph {
  std::uint32_t font = 0, glyph = 0;
  std::uint32_t character = 0;  // index of its first character in the line's paragraph
  double x = 0, y = 0;          // pen position: right of the line's left end, above its baseline
  double advance = 0;           // to the next glyph's pen, not counting the offsets of marks
};

struct TextLine {
  std::vector<PlacedGlyph> glyphs;  // from left to right
  double width = 0;
  double left = 0;      // from the block's left
  double baseline = 0;  // below the block's top
  std::string text;     // UTF-8, in logical order
};

struct TextBlock {
  std::vector<TextLine> lines;
  double width = 0, height = 0;
  bool cut = false;  // did not fit and ends with an ellipsis
};

}  // namespace prosector
