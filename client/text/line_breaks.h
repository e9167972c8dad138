#pragma once
// Line breaking of a paragraph. Private to client/text.

#include "client/text/paragraph.h"

namespace prosector {

struct ParagraphLine {
  TextLine line;
  std::size_t first;  // index in the paragraph's characters
};

/// Breaks the paragraph into lines of at most `width` (em): at blanks, after hyphens, between ideographs.
/// Breaks within a word only if the word alone is wider. A line has at least one cluster. Blanks at a break
/// are removed. `width` 0: one line.
std::vector<ParagraphLine> broken(const Paragraph& paragraph, double width);

/// Returns one line with as many of the characters as fit, and an ellipsis. `width` 0: all of them.
TextLine with_ellipsis(Fonts& fonts, const std::u32string& characters, Direction direction, double width);

}  // namespace prosector
