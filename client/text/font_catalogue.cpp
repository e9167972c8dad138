#include "client/text/font_catalogue.h"

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>

#include <array>

#include "common/error.h"

namespace prosector {
namespace {

/// The base font, and fonts for the scripts that it lacks, each in a small Debian package.
constexpr std::array<const char*, 3> preferred = {"DejaVu Sans", "Lohit Devanagari", "Droid Sans Fallback"};

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
using Config = std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)>;
using Patterns = std::unique_ptr<FcFontSet, decltype(&FcFontSetDestroy)>;

const FcChar8* bytes(const char* text) {
  return reinterpret_cast<const FcChar8*>(text);
}

std::string string_of(const FcPattern* font, const char* key) {
  FcChar8* value = nullptr;
  return FcPatternGetString(font, key, 0, &value) == FcResultMatch ? reinterpret_cast<const char*>(value)
                                                                   : std::string();
}

/// Makes a pattern for upright outline fonts of regular weight. User configuration is ignored, because it
/// would change how the same text looks.
Pattern wish() {
  Pattern pattern(FcPatternCreate(), &FcPatternDestroy);
  for (const char* family : preferred) FcPatternAddString(pattern.get(), FC_FAMILY, bytes(family));
  FcPatternAddInteger(pattern.get(), FC_WEIGHT, FC_WEIGHT_REGULAR);
  FcPatternAddInteger(pattern.get(), FC_SLANT, FC_SLANT_ROMAN);
  FcPatternAddInteger(pattern.get(), FC_WIDTH, FC_WIDTH_NORMAL);
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  FcPatternAddBool(pattern.get(), FC_COLOR, FcFalse);
  return pattern;
}

bool is_outline(const FcPattern* font) {
  FcBool outline = FcFalse, color = FcFalse;
  FcPatternGetBool(font, FC_OUTLINE, 0, &outline);
  FcPatternGetBool(font, FC_COLOR, 0, &color);
  return outline == FcTrue && color == FcFalse;
}

FontFile file_of(const FcPattern* font) {
  FontFile file{string_of(font, FC_FILE), 0, string_of(font, FC_FAMILY)};
  FcPatternGetInteger(font, FC_INDEX, 0, &file.index);
  return file;
}

std::shared_ptr<const FcCharSet> characters_in(const FcPattern* font) {
  FcCharSet* set = nullptr;
  if (FcPatternGetCharSet(font, FC_CHARSET, 0, &set) != FcResultMatch) return nullptr;
  return {FcCharSetCopy(set), &FcCharSetDestroy};
}

}  // namespace

FontCatalogue::FontCatalogue() {
  FcResult result = FcResultNoMatch;
  // A separate configuration, freed afterwards.
  const Config config(FcInitLoadConfigAndFonts(), &FcConfigDestroy);
  const Pattern pattern = wish();
  const Patterns sorted(FcFontSort(config.get(), pattern.get(), FcTrue, nullptr, &result), &FcFontSetDestroy);
  for (int k = 0; sorted && k < sorted->nfont; ++k) {
    const FcPattern* font = sorted->fonts[k];
    if (auto characters = characters_in(font); characters && is_outline(font))
      entries_.push_back({file_of(font), std::move(characters)});
  }
  if (entries_.empty())
    throw InputError("text: fontconfig finds no usable font; install the Debian package fonts-dejavu-core");
}

FontCatalogue::FontCatalogue(const std::vector<std::filesystem::path>& files) {
  for (const auto& path : files) {
    int faces = 0;
    const Pattern font(FcFreeTypeQuery(bytes(path.c_str()), 0, nullptr, &faces), &FcPatternDestroy);
    auto characters = font ? characters_in(font.get()) : nullptr;
    if (!characters) throw InputError(fmt::format("text: {} is not a font", path.string()));
    entries_.push_back({file_of(font.get()), std::move(characters)});
  }
  if (entries_.empty()) throw InputError("text: a font catalogue needs at least one font");
}

bool FontCatalogue::has(std::size_t font, char32_t character) const {
  return FcCharSetHasChar(entries_.at(font).characters.get(), character) == FcTrue;
}

}  // namespace prosector
