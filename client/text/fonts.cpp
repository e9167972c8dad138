#include "client/text/fonts.h"

#include <ft2build.h>

#include "common/error.h"
#include FT_FREETYPE_H

namespace prosector {

Fonts::Fonts(FontCatalogue catalogue)
    : catalogue_(std::move(catalogue)), opened_(catalogue_.size()), broken_(catalogue_.size(), false) {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) throw InputError("text: cannot initialise FreeType");
  library_.reset(library, &FT_Done_FreeType);
  FontId first = 0;
  while (first < catalogue_.size() && !open(first)) ++first;
  if (first == catalogue_.size())
    throw InputError(
        "text: FreeType cannot open any of the fonts; install the Debian package fonts-dejavu-core");
}

FontId Fonts::font_of(char32_t character) {
  if (const auto known = found_.find(character); known != found_.end()) return known->second;
  FontId first = 0;
  while (broken_[first]) ++first;
  FontId font = first;
  while (font < catalogue_.size() && !(catalogue_.has(font, character) && open(font))) ++font;
  if (font == catalogue_.size()) font = first;
  found_.emplace(character, font);
  return font;
}

bool Fonts::open(FontId font) {
  if (opened_[font] || broken_[font]) return !broken_[font];
  try {
    opened_[font].emplace(library_.get(), catalogue_.file(font));
  } catch (const InputError&) {
    broken_[font] = true;  // another font has the character, or a box is drawn
  }
  return !broken_[font];
}

}  // namespace prosector
