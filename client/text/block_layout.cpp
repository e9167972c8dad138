#include "client/text/block_layout.h"

#include <algorithm>
#include <cmath>

#include "client/text/line_breaks.h"

namespace prosector {
namespace {

constexpr double column_gap = 1;  // em

std::vector<std::u32string_view> split(std::u32string_view text, char32_t at) {
  std::vector<std::u32string_view> parts;
  for (std::size_t end = 0; end != text.npos;) {
    end = text.find(at);
    parts.push_back(text.substr(0, end));
    if (end != text.npos) text.remove_prefix(end + 1);
  }
  return parts;
}

/// Returns the columns' positions, from the lines that have columns.
std::vector<double> columns_of(Fonts& fonts, const std::vector<std::u32string_view>& lines) {
  std::vector<double> widths;
  for (const std::u32string_view line : lines) {
    const auto cells = split(line, U'\t');
    for (std::size_t k = 0; k + 1 < cells.size(); ++k) {
      const Paragraph cell(fonts, std::u32string(cells[k]));
      if (k >= widths.size()) widths.push_back(0);
      widths[k] = std::max(widths[k], cell.line(0, cells[k].size()).width);
    }
  }
  std::vector<double> begins = {0};
  for (const double width : widths) begins.push_back(begins.back() + width + column_gap);
  return begins;
}

/// A line with the data needed to set it again with an ellipsis.
struct Row {
  TextLine line;
  TextLine columns;     // the columns before its last one
  double begins = 0;    // of its last column, em
  std::u32string rest;  // of its paragraph, from the start of the last column's text
  Direction direction = Direction::left_to_right;
};

TextLine joined(TextLine line, double begins, const TextLine& cell) {
  for (PlacedGlyph glyph : cell.glyphs) {
    glyph.x += begins;
    line.glyphs.push_back(glyph);
  }
  line.width = begins + cell.width;
  line.text += cell.text;
  return line;
}

class Layout {
 public:
  Layout(Fonts& fonts, const BlockFrame& frame) : fonts_(fonts), frame_(frame) {}

  void add(std::u32string_view line, const std::vector<double>& begins) {
    const auto cells = split(line, U'\t');
    TextLine columns;
    for (std::size_t k = 0; k + 1 < cells.size(); ++k) {
      const Paragraph cell(fonts_, std::u32string(cells[k]));
      columns = joined(std::move(columns), begins[k], cell.line(0, cells[k].size()));
      columns.text += '\t';
    }
    const double last = begins[cells.size() - 1];
    const Paragraph cell(fonts_, std::u32string(cells.back()));
    for (const ParagraphLine& part : broken(cell, room(last))) {
      rows_.push_back({joined(columns, last, part.line), columns, last, cell.characters().substr(part.first),
                       cells.size() == 1 ? cell.direction() : Direction::left_to_right});
      columns = {};
    }
  }

  TextBlock finish() {
    TextBlock block;
    cut_to_height(block);
    for (const Row& row : rows_) block.width = std::max(block.width, row.line.width);
    const bool right = std::any_of(rows_.begin(), rows_.end(), [](const Row& row) { return runs_left(row); });
    if (right && !frame_.centred) block.width = std::max(block.width, frame_.width);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      TextLine& line = rows_[k].line;
      const double over = block.width - line.width;
      line.left = frame_.centred ? over / 2 : runs_left(rows_[k]) ? over : 0;
      line.baseline = line_ascent + line_spacing * static_cast<double>(k);
      block.lines.push_back(std::move(line));
    }
    block.height = height_of_lines(block.lines.size());
    return block;
  }

 private:
  static bool runs_left(const Row& row) { return row.direction == Direction::right_to_left; }

  /// Returns the width available from `begins` on; at least 4 em, or the frame's width if that is less.
  double room(double begins) const {
    constexpr double least = 4;
    return frame_.width > 0 ? std::max(frame_.width - begins, std::min(least, frame_.width)) : 0;
  }

  void cut_to_height(TextBlock& block) {
    if (frame_.height <= 0) return;
    constexpr double slack = 1e-9;
    std::size_t most = 1;
    while (height_of_lines(most + 1) <= frame_.height + slack) ++most;
    if (rows_.size() <= most) return;
    block.cut = true;
    rows_.resize(most);
    Row& row = rows_.back();
    row.line =
        joined(row.columns, row.begins, with_ellipsis(fonts_, row.rest, row.direction, room(row.begins)));
  }

  Fonts& fonts_;
  BlockFrame frame_;
  std::vector<Row> rows_;
};

}  // namespace

TextBlock lay_out(Fonts& fonts, std::u32string_view characters, const BlockFrame& frame) {
  const auto lines = split(characters, U'\n');
  const std::vector<double> columns = columns_of(fonts, lines);
  Layout layout(fonts, frame);
  for (const std::u32string_view line : lines) layout.add(line, columns);
  return layout.finish();
}

}  // namespace prosector
