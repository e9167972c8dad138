#pragma once
// Layout of lines into a block. Private to client/text.

#include <string_view>

#include "client/text/paragraph.h"

namespace prosector {

struct BlockFrame {
  double width = 0, height = 0;  // em; 0: any
  bool centred = false;
};

/// Lays out lines, columns and paragraphs as documented at Typesetter::set().
TextBlock lay_out(Fonts& fonts, std::u32string_view characters, const BlockFrame& frame);

}  // namespace prosector
