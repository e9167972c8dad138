#pragma once
// Sets text: any script, in lines, as large as there is room for.

#include <string_view>

#include "client/text/fonts.h"
#include "client/text/text_block.h"

namespace prosector {

/// How large a text is to be, and what it has to fit into. All in one unit: pixels, points or metres.
struct TextFrame {
  double size = 1;        // of the em, if it fits
  double least_size = 0;  // down to which it shrinks rather than being cut; 0: it does not shrink
  double width = 0;       // lines are broken at it; 0: only at '\n'
  double height = 0;      // what does not fit into it ends with an ellipsis; 0: any
  bool centred = false;   // each line in the middle of the block
};

struct SetText {
  std::shared_ptr<const TextBlock> block;
  double size;  // of the em, in the frame's unit

  double width() const { return size * block->width; }
  double height() const { return size * block->height; }
};

class Typesetter {
 public:
  /// Sets with this system's fonts. Throws InputError, naming the Debian package, when there is none.
  Typesetter() : Typesetter(FontCatalogue()) {}
  explicit Typesetter(FontCatalogue catalogue) : fonts_(std::move(catalogue)) {}

  /// Sets UTF-8 of any content. Lines are as their first letter's script runs: from the left, or from the
  /// right and then flush with the frame's right. A '\t' begins a column: all lines with one share its place,
  /// and what is in the last column is broken within it. What was set lately is remembered.
  SetText set(std::string_view text, const TextFrame& frame);

  const Font& font(FontId font) const { return fonts_.at(font); }
  Fonts& fonts() { return fonts_; }

 private:
  static constexpr std::size_t most_remembered = 512;

  SetText fit(std::string_view text, const TextFrame& frame);

  Fonts fonts_;
  std::unordered_map<std::string, SetText> remembered_;
};

}  // namespace prosector
