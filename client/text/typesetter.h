#pragma once
// Typesetting of text in any script: lines, columns and shrinking to fit.

#include <string_view>

#include "client/text/fonts.h"
#include "client/text/text_block.h"

namespace prosector {

/// Size of a text, and the area that it must fit into. All lengths have the same unit: pixels, points or
/// metres.
struct TextFrame {
  double size = 1;        // of the em; reduced if the text does not fit
  double least_size = 0;  // minimum em size; smaller would be cut instead; 0: it does not shrink
  double width = 0;       // maximum line width; 0: lines end only at '\n'
  double height = 0;      // text beyond it is replaced by an ellipsis; 0: unlimited
  bool centred = false;   // each line centred in the block
};

struct SetText {
  std::shared_ptr<const TextBlock> block;
  double size;  // of the em, in the frame's unit

  double width() const { return size * block->width; }
  double height() const { return size * block->height; }
};

class Typesetter {
 public:
  /// Creates a typesetter that uses this system's fonts. Throws InputError with the name of the Debian
  /// package to install if there are none.
  Typesetter() : Typesetter(FontCatalogue()) {}
  explicit Typesetter(FontCatalogue catalogue) : fonts_(std::move(catalogue)) {}

  /// Lays out UTF-8 text in any script, and returns its lines with the size at which it fits the frame. Each
  /// line has the direction of its first letter's script; right-to-left lines are aligned with the frame's
  /// right. A '\t' begins a column, which is aligned over all lines with one; the last column's text is
  /// wrapped within it. Recent results are cached.
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
