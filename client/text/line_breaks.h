#pragma once
// Where a paragraph is broken into lines. Private to client/text.

#include "client/text/paragraph.h"

namespace prosector {

struct BrokenLine {
  TextLine line;
  std::size_t first;  // of the paragraph's characters
};

/// Breaks the paragraph into lines that are no wider than `width` (em): at blanks, after hyphens, between
/// ideographs; within a word only where it is wider by itself. A line has at least one cluster. Blanks at
/// which it is broken are left out. `width` 0: one line.
std::vector<BrokenLine> broken(const Paragraph& paragraph, double width);

/// Returns one line of as many of the characters as there is room for, and an ellipsis. `width` 0: all of
/// them.
TextLine with_ellipsis(Fonts& fonts, const std::u32string& characters, Direction direction, double width);

}  // namespace prosector
