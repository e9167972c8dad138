#pragma once
// Layout of lines into a block. Private to client/text.

#include <string_view>

#include "client/text/paragraph.h"

namespace prosector {

struct BlockFrame {
  double width = 0, height = 0;  // em; 0: any
  bool centred = false;
};

/// Lays out the lines, tab-separated columns and paragraphs of a text in a frame, and returns the glyphs'
/// positions in em. Typesetter::set() documents the rules of alignment, wrapping and shortening.
TextBlock lay_out(Fonts& fonts, std::u32string_view characters, const BlockFrame& frame);

}  // namespace prosector
