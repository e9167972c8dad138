#pragma once
// A pen-stroke font of our own for ASCII 32…126. No GL.

#include <string>
#include <string_view>
#include <vector>

#include "common/math.h"

namespace prosector {

struct TextStroke {
  Eigen::Vector2d a, b;  // pixels right of and below the top left of the first line
};

/// Returns the strokes of a text. `height` is that of one line from ascender to descender, pixels. UTF-8: any
/// other character becomes '?'. '\n' starts a new line.
std::vector<TextStroke> strokes_of(std::string_view text, double height);

/// Returns the width of the longest line, pixels.
double text_width(std::string_view text, double height);

/// Breaks the text at blanks so that lines are no wider than `width`, except words that are.
std::string wrapped(std::string_view text, double height, double width);

/// Returns the distance from one line's top to the next one's, pixels.
double line_spacing(double height);

}  // namespace prosector
