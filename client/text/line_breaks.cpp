#include "client/text/line_breaks.h"

#include <hb.h>

#include <algorithm>
#include <string_view>

namespace prosector {
namespace {

constexpr double slack = 1e-9;  // em: rounding error of sums in another order

bool is_blank(char32_t c) {
  // Excludes the non-breaking ones (U+00A0, U+2007, U+202F).
  return c == U' ' || c == U'\t' || c == 0x1680 || (c >= 0x2000 && c <= 0x200B && c != 0x2007) ||
         c == 0x205F || c == 0x3000;
}

/// Returns whether the character's script is written without blanks and may be broken between characters.
bool is_ideograph(char32_t c) {
  switch (hb_unicode_script(hb_unicode_funcs_get_default(), c)) {
    case HB_SCRIPT_HAN:
    case HB_SCRIPT_HIRAGANA:
    case HB_SCRIPT_KATAKANA:
    case HB_SCRIPT_BOPOMOFO:
    case HB_SCRIPT_YI:
      return true;
    default:
      return false;
  }
}

bool begins_no_line(char32_t c) {
  return std::u32string_view(
             U"、。，．！？；：）】》」』〕｝ー々…ぁぃぅぇぉっゃゅょァィゥェォッャュョ,.!?;:)]}")
             .find(c) != std::u32string_view::npos;
}

bool ends_no_line(char32_t c) {
  return std::u32string_view(U"（【《「『〔｛([{").find(c) != std::u32string_view::npos;
}

/// Returns whether a line may end between two characters.
bool may_break(char32_t before, char32_t after) {
  if (is_blank(after)) return false;
  if (is_blank(before)) return true;
  if (before == U'-' || before == 0x2010 || before == 0x2013 || before == 0x00AD) return true;
  if (begins_no_line(after) || ends_no_line(before)) return false;
  return is_ideograph(before) || is_ideograph(after);
}

class Breaker {
 public:
  Breaker(const Paragraph& paragraph, double width)
      : paragraph_(paragraph),
        text_(paragraph.characters()),
        width_(width),
        advances_(paragraph.advances()) {}

  std::vector<ParagraphLine> lines() const {
    std::vector<ParagraphLine> out;
    for (std::size_t first = 0; first < text_.size();) {
      std::size_t end = end_of_line(first);
      TextLine fitting = line(first, end);
      // A line's glyphs may be wider than in the unbroken paragraph, because letters that were joined no
      // longer are.
      while (fitting.width > width_ + slack && shorter(first, end) > first) {
        end = shorter(first, end);
        fitting = line(first, end);
      }
      out.push_back({std::move(fitting), first});
      first = end;
      while (first < text_.size() && is_blank(text_[first])) ++first;
    }
    if (out.empty()) out.push_back({paragraph_.line(0, 0), 0});
    return out;
  }

 private:
  bool begins_cluster(std::size_t k) const { return k >= text_.size() || advances_[k] >= 0; }

  TextLine line(std::size_t first, std::size_t end) const {
    while (end > first && is_blank(text_[end - 1])) --end;
    return paragraph_.line(first, end);
  }

  /// Returns the end of the longest line from `first` on that fits, or the end of its first cluster.
  std::size_t end_of_line(std::size_t first) const {
    double so_far = 0;
    std::size_t best = first;  // after a word
    for (std::size_t k = first; k < text_.size(); ++k) {
      if (k > first && begins_cluster(k) && may_break(text_[k - 1], text_[k])) best = k;
      so_far += std::max(advances_[k], 0.0);
      if (so_far > width_ + slack && !is_blank(text_[k])) {
        if (best > first) return best;
        const std::size_t within = cluster_at(k);
        return within > first ? within : next_cluster(first);
      }
    }
    return text_.size();
  }

  /// Returns an earlier end: after the previous word, else the previous cluster; `first` if there is none.
  std::size_t shorter(std::size_t first, std::size_t end) const {
    for (std::size_t k = end - 1; k > first; --k)
      if (begins_cluster(k) && may_break(text_[k - 1], text_[k])) return k;
    return end > first + 1 ? cluster_at(end - 1) : first;
  }

  std::size_t cluster_at(std::size_t k) const {
    while (k > 0 && !begins_cluster(k)) --k;
    return k;
  }
  std::size_t next_cluster(std::size_t k) const {
    do ++k;
    while (!begins_cluster(k));
    return k;
  }

  const Paragraph& paragraph_;
  const std::u32string& text_;
  double width_;
  std::vector<double> advances_;
};

}  // namespace

std::vector<ParagraphLine> broken(const Paragraph& paragraph, double width) {
  if (width <= 0) return {{paragraph.line(0, paragraph.characters().size()), 0}};
  return Breaker(paragraph, width).lines();
}

TextLine with_ellipsis(Fonts& fonts, const std::u32string& characters, Direction direction, double width) {
  const std::vector<double> advances = Paragraph(fonts, characters, direction).advances();
  std::size_t end = 0;
  for (double so_far = 0; end < characters.size() && (width <= 0 || so_far <= width); ++end)
    so_far += std::max(advances[end], 0.0);
  while (true) {
    while (end > 0 && is_blank(characters[end - 1])) --end;
    const Paragraph cut(fonts, characters.substr(0, end) + U'…', direction);
    TextLine line = cut.line(0, end + 1);
    if (end == 0 || width <= 0 || line.width <= width + slack) return line;
    do --end;
    while (end > 0 && advances[end] < 0);
  }
}

}  // namespace prosector
