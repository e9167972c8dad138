#pragma once
// The fonts of a catalogue, opened on demand.

#include <optional>
#include <unordered_map>

#include "client/text/font.h"

namespace prosector {

using FontId = std::uint32_t;  // index in the catalogue

class Fonts {
 public:
  explicit Fonts(FontCatalogue catalogue);

  /// Returns the first font with the character. If there is none, returns the first font, which draws a box.
  FontId font_of(char32_t character);
  bool has(FontId font, char32_t character) const { return catalogue_.has(font, character); }
  /// Returns a font by an id from font_of().
  const Font& at(FontId font) const { return *opened_.at(font); }
  const FontCatalogue& catalogue() const { return catalogue_; }

 private:
  bool open(FontId font);

  FontCatalogue catalogue_;
  std::shared_ptr<FT_LibraryRec_> library_;
  std::vector<std::optional<Font>> opened_;
  std::vector<bool> broken_;  // cannot be opened
  std::unordered_map<char32_t, FontId> found_;
};

}  // namespace prosector
