#pragma once
// Line breaking of a paragraph. Private to client/text.

#include "client/text/paragraph.h"

namespace prosector {

struct ParagraphLine {
  TextLine line;
  std::size_t first;  // index in the paragraph's characters
};

/// Breaks the paragraph into lines of at most `width` (em). Lines end at blanks, after hyphens, or between
/// ideographs, and within a word only if the word alone is wider. A line has at least one cluster (group of
/// characters that is drawn as a unit). Blanks at a break are removed. `width` 0: returns a single line.
std::vector<ParagraphLine> broken(const Paragraph& paragraph, double width);

/// Returns one line with as many of the characters as fit into `width` (em) together with a final ellipsis.
/// `width` 0: returns all characters and the ellipsis.
TextLine with_ellipsis(Fonts& fonts, const std::u32string& characters, Direction direction, double width);

}  // namespace prosector
