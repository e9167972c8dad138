#pragma once
// Text as it is laid out, independent of the size at which it is drawn. Lengths are in em: times the text's
// size, they are pixels, points or metres.

#include <cstdint>
#include <string>
#include <vector>

namespace prosector {

/// What a line takes, in every script, so that a text's height follows from how many lines it has.
inline constexpr double line_ascent = 0.93, line_descent = 0.24;  // above and below the baseline
inline constexpr double line_spacing = 1.3;                       // from a baseline to the next

/// Returns the height of so many lines.
constexpr double height_of_lines(std::size_t lines) {
  return lines == 0 ? 0 : line_ascent + line_descent + line_spacing * static_cast<double>(lines - 1);
}

struct PlacedGlyph {
  std::uint32_t font = 0, glyph = 0;
  std::uint32_t character = 0;  // the first one that it stands for, of the line's paragraph
  double x = 0, y = 0;          // its pen: right of the line's left end, above its baseline
  double advance = 0;           // to where the next one's pen begins, but for the offsets of marks
};

struct TextLine {
  std::vector<PlacedGlyph> glyphs;  // from left to right
  double width = 0;
  double left = 0;      // from the block's left
  double baseline = 0;  // below the block's top
  std::string text;     // UTF-8, in the order in which it is read
};

struct TextBlock {
  std::vector<TextLine> lines;
  double width = 0, height = 0;
  bool cut = false;  // did not fit: ends with an ellipsis
};

}  // namespace prosector
