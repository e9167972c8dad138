#include "client/text/paragraph.h"

#include <fribidi.h>
#include <hb.h>

#include <algorithm>
#include <numeric>

#include "client/text/utf8.h"

namespace prosector {
namespace {

static_assert(sizeof(FriBidiChar) == sizeof(char32_t) && sizeof(FriBidiCharType) == sizeof(std::uint32_t));

const std::uint32_t* plain(const std::u32string& text) {
  return reinterpret_cast<const std::uint32_t*>(text.data());
}

FriBidiParType wished(Direction direction) {
  switch (direction) {
    case Direction::left_to_right:
      return FRIBIDI_PAR_LTR;
    case Direction::right_to_left:
      return FRIBIDI_PAR_RTL;
    case Direction::as_written:
      break;
  }
  return FRIBIDI_PAR_ON;
}

hb_unicode_general_category_t category_of(char32_t c) {
  return hb_unicode_general_category(hb_unicode_funcs_get_default(), c);
}

/// Returns whether the character takes the font of the preceding one: marks, joiners and blanks.
bool follows(char32_t c) {
  switch (category_of(c)) {
    case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_FORMAT:
    case HB_UNICODE_GENERAL_CATEGORY_SPACE_SEPARATOR:
      return true;
    default:
      return false;
  }
}

/// Returns whether the character alone is invisible in any font.
bool is_invisible(char32_t c) {
  return category_of(c) == HB_UNICODE_GENERAL_CATEGORY_FORMAT || (c >= 0xFE00 && c <= 0xFE0F);
}

}  // namespace

Paragraph::Paragraph(Fonts& fonts, std::u32string characters, Direction direction)
    : fonts_(&fonts), characters_(std::move(characters)), base_(wished(direction)) {
  const auto count = static_cast<FriBidiStrIndex>(characters_.size());
  types_.resize(characters_.size());
  levels_.resize(characters_.size());
  std::vector<FriBidiBracketType> brackets(characters_.size());
  fribidi_get_bidi_types(plain(characters_), count, types_.data());
  fribidi_get_bracket_types(plain(characters_), count, types_.data(), brackets.data());
  auto base = static_cast<FriBidiParType>(base_);
  if (fribidi_get_par_embedding_levels_ex(types_.data(), brackets.data(), count, &base, levels_.data()) == 0)
    levels_.assign(characters_.size(), 0);  // out of memory, or too deeply nested
  base_ = base;
  choose_scripts();
  choose_fonts();
}

Direction Paragraph::direction() const {
  return FRIBIDI_IS_RTL(base_) ? Direction::right_to_left : Direction::left_to_right;
}

/// Sets each character's script. Characters common to all scripts (digits, marks) get the script of the
/// preceding character, and at the beginning that of the following one.
void Paragraph::choose_scripts() {
  scripts_.assign(characters_.size(), HB_SCRIPT_COMMON);
  std::uint32_t script = HB_SCRIPT_COMMON;
  std::size_t without = 0;
  for (std::size_t k = 0; k < characters_.size(); ++k) {
    const hb_script_t own = hb_unicode_script(hb_unicode_funcs_get_default(), characters_[k]);
    if (own != HB_SCRIPT_COMMON && own != HB_SCRIPT_INHERITED && own != HB_SCRIPT_UNKNOWN) {
      script = own;
      for (; without < k; ++without)
        if (scripts_[without] == HB_SCRIPT_COMMON) scripts_[without] = script;
    }
    scripts_[k] = script;
  }
}

void Paragraph::choose_fonts() {
  used_fonts_.clear();
  for (const char32_t c : characters_) {
    const bool stays =
        !used_fonts_.empty() && (is_invisible(c) || (follows(c) && fonts_->has(used_fonts_.back(), c)));
    used_fonts_.push_back(stays ? used_fonts_.back() : fonts_->font_of(c));
  }
}

std::vector<Paragraph::Run> Paragraph::runs_from_left(std::size_t first, std::size_t end) const {
  std::vector<FriBidiStrIndex> order(characters_.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<FriBidiLevel> levels(levels_.begin(), levels_.end());
  // Reorders the indices of the line, and resets the levels of trailing blanks. Without memory it changes
  // neither.
  [[maybe_unused]] const FriBidiLevel most =
      fribidi_reorder_line(FRIBIDI_FLAGS_DEFAULT & ~FRIBIDI_FLAG_REORDER_NSM, types_.data(),
                           static_cast<FriBidiStrIndex>(end - first), static_cast<FriBidiStrIndex>(first),
                           static_cast<FriBidiParType>(base_), levels.data(), nullptr, order.data());
  std::vector<Run> runs;
  for (std::size_t place = first; place < end; ++place) {
    const auto k = static_cast<std::size_t>(order[place]);
    const auto belongs = [&](std::size_t neighbour) {
      return levels[neighbour] == levels[k] && scripts_[neighbour] == scripts_[k] &&
             used_fonts_[neighbour] == used_fonts_[k];
    };
    const bool backwards = levels[k] % 2 != 0;
    if (!runs.empty() && !backwards && runs.back().end == k && belongs(k - 1)) {
      ++runs.back().end;
    } else if (!runs.empty() && backwards && runs.back().first == k + 1 && belongs(k + 1)) {
      --runs.back().first;
    } else {
      runs.push_back({k, k + 1});
    }
  }
  return runs;
}

void Paragraph::shape(const Run& run, TextLine& line) const {
  const Font& font = fonts_->at(used_fonts_[run.first]);
  const std::unique_ptr<hb_buffer_t, decltype(&hb_buffer_destroy)> buffer(hb_buffer_create(),
                                                                          &hb_buffer_destroy);
  hb_buffer_add_utf32(buffer.get(), plain(characters_), static_cast<int>(characters_.size()),
                      static_cast<unsigned>(run.first), static_cast<int>(run.end - run.first));
  hb_buffer_set_direction(buffer.get(), levels_[run.first] % 2 != 0 ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
  hb_buffer_set_script(buffer.get(), static_cast<hb_script_t>(scripts_[run.first]));
  hb_shape(font.shaping(), buffer.get(), nullptr, 0);
  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
  const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer.get(), &count);
  const double em = font.units_per_em();
  for (unsigned k = 0; k < count; ++k) {
    line.glyphs.push_back({used_fonts_[run.first], infos[k].codepoint, infos[k].cluster,
                           line.width + positions[k].x_offset / em, positions[k].y_offset / em,
                           positions[k].x_advance / em});
    line.width += line.glyphs.back().advance;
  }
}

TextLine Paragraph::line(std::size_t first, std::size_t end) const {
  TextLine line;
  line.text = utf8_of(std::u32string_view(characters_).substr(first, end - first));
  for (const Run& run : runs_from_left(first, end)) shape(run, line);
  return line;
}

std::vector<double> Paragraph::advances() const {
  std::vector<double> out(characters_.size(), -1);
  for (const Run& run : runs_from_left(0, characters_.size())) {
    TextLine line;
    shape(run, line);
    for (const PlacedGlyph& glyph : line.glyphs)
      out[glyph.character] = std::max(out[glyph.character], 0.0) + glyph.advance;
  }
  return out;
}

}  // namespace prosector
