#include "client/render/stroke_font.h"

#include <algorithm>
#include <array>

namespace prosector {
namespace {

// Each glyph is polylines separated by blanks; a point is two digits, x and y. x is 0…4. Of y, 8 is the
// height of capitals, 6 that of small letters, 2 the base line and 0 the descender.
constexpr std::array<std::string_view, 95> glyphs = {
    /*   */ "",
    /* ! */ "2824 2222",
    /* " */ "1816 3836",
    /* # */ "1317 3337 0444 0646",
    /* $ */ "473818070615354443321203 2921",
    /* % */ "0248 0818170708 3343423233",
    /* & */ "4216172837360403122244",
    /* ' */ "2826",
    /* ( */ "38272332",
    /* ) */ "18272312",
    /* * */ "2723 0644 0446",
    /* + */ "2622 0444",
    /* , */ "232211",
    /* - */ "0444",
    /* . */ "2222",
    /* / */ "0248",
    /* 0 */ "183847433212030718 1337",
    /* 1 */ "072822 1232",
    /* 2 */ "07183847460242",
    /* 3 */ "0718384746354443321203 1535",
    /* 4 */ "32380444",
    /* 5 */ "480805354443321203",
    /* 6 */ "473818070312324344351504",
    /* 7 */ "08484612",
    /* 8 */ "15060718384746354443321203041535",
    /* 9 */ "031232434738180706153546",
    /* : */ "2525 2222",
    /* ; */ "2525 232211",
    /* < */ "460442",
    /* = */ "0545 0343",
    /* > */ "064402",
    /* ? */ "071838474624 2222",
    /* @ */ "36161434 36344447381807031242",
    /* A */ "0206284642 0444",
    /* B */ "02083847463505 3544433202",
    /* C */ "4738180703123243",
    /* D */ "02082846442202",
    /* E */ "48080242 0535",
    /* F */ "480802 0535",
    /* G */ "47381807031232434525",
    /* H */ "0802 4842 0545",
    /* I */ "1838 2822 1232",
    /* J */ "4843321203",
    /* K */ "0802 480542",
    /* L */ "080242",
    /* M */ "0208254842",
    /* N */ "02084248",
    /* O */ "183847433212030718",
    /* P */ "02083847463505",
    /* Q */ "183847433212030718 2442",
    /* R */ "02083847463505 2542",
    /* S */ "473818070615354443321203",
    /* T */ "0848 2822",
    /* U */ "080312324348",
    /* V */ "082248",
    /* W */ "0812253248",
    /* X */ "0842 4802",
    /* Y */ "082548 2522",
    /* Z */ "08480242",
    /* [ */ "38181232",
    /* \ */ "0842",
    /* ] */ "18383212",
    /* ^ */ "062846",
    /* _ */ "0141",
    /* ` */ "1827",
    /* a */ "4642 4536160503123243",
    /* b */ "0802 0516364543321203",
    /* c */ "4536160503123243",
    /* d */ "4842 4536160503123243",
    /* e */ "04444536160503123243",
    /* f */ "47382722 1636",
    /* g */ "4641301001 4536160503123243",
    /* h */ "0802 0516364542",
    /* i */ "162622 1232 2828",
    /* j */ "262110 2828",
    /* k */ "0802 460442",
    /* l */ "18282332",
    /* m */ "0602 05162522 25364542",
    /* n */ "0602 0516364542",
    /* o */ "163645433212030516",
    /* p */ "0600 0516364543321203",
    /* q */ "4640 4536160503123243",
    /* r */ "0602 05163645",
    /* s */ "45361605143443321203",
    /* t */ "282332 1636",
    /* u */ "0603123243 4642",
    /* v */ "062246",
    /* w */ "0612243246",
    /* x */ "0642 4602",
    /* y */ "0603123243 4641301001",
    /* z */ "06460242",
    /* { */ "38272615242332",
    /* | */ "2821",
    /* } */ "18272635242312",
    /* ~ */ "04153445",
};

constexpr double top = 8, advance = 6;  // grid units
constexpr double aspect = 0.82;         // width of a grid unit over its height

struct Scale {
  double x, y;  // pixels for a grid unit
};

Scale scale_of(double height) {
  return {aspect * height / top, height / top};
}

std::string_view glyph_of(char c) {
  const int index = static_cast<unsigned char>(c) - 32;
  return index >= 0 && index < static_cast<int>(glyphs.size()) ? glyphs[static_cast<std::size_t>(index)]
                                                               : glyphs['?' - 32];
}

bool continues_utf8(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

void add_glyph(std::vector<TextStroke>& out, std::string_view glyph, const Eigen::Vector2d& at,
               const Scale& scale) {
  bool pen_down = false;
  Eigen::Vector2d last = at;
  for (std::size_t k = 0; k + 1 < glyph.size();) {
    if (glyph[k] == ' ') {
      pen_down = false;
      ++k;
      continue;
    }
    const Eigen::Vector2d point =
        at + Eigen::Vector2d((glyph[k] - '0' + 0.5) * scale.x, (top - (glyph[k + 1] - '0')) * scale.y);
    if (pen_down) out.push_back({last, point});
    last = point;
    pen_down = true;
    k += 2;
  }
}

}  // namespace

std::vector<TextStroke> strokes_of(std::string_view text, double height) {
  const Scale scale = scale_of(height);
  std::vector<TextStroke> out;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  for (const char c : text) {
    if (continues_utf8(c)) continue;
    if (c == '\n') {
      at = {0, at.y() + line_spacing(height)};
      continue;
    }
    add_glyph(out, glyph_of(c), at, scale);
    at.x() += advance * scale.x;
  }
  return out;
}

double text_width(std::string_view text, double height) {
  std::size_t longest = 0, length = 0;
  for (const char c : text) {
    length = c == '\n' ? 0 : length + (continues_utf8(c) ? 0 : 1);
    longest = std::max(longest, length);
  }
  return static_cast<double>(longest) * advance * scale_of(height).x;
}

std::string wrapped(std::string_view text, double height, double width) {
  std::string out, line;
  const auto end_line = [&] {
    out += (out.empty() ? "" : "\n") + line;
    line.clear();
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string word(text.substr(0, end));
    const std::string longer = line.empty() ? word : line + ' ' + word;
    if (!line.empty() && text_width(longer, height) > width) {
      end_line();
      line = word;
    } else {
      line = longer;
    }
    if (end < text.size() && text[end] == '\n') end_line();
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  end_line();
  return out;
}

double line_spacing(double height) {
  return 1.3 * height;
}

}  // namespace prosector
