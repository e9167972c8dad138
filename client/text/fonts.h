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

  /// Returns the first font of the catalogue that has the character and can be opened, and opens it. If there
  /// is none, returns the first usable font, which draws a box for the character.
  FontId font_of(char32_t character);
  bool has(FontId font, char32_t character) const { return catalogue_.has(font, character); }
  /// Returns the opened font with an id that font_of() returned.
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
