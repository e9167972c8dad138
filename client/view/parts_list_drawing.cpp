#include <algorithm>

#include "client/text/text_block.h"
#include "client/view/parts_list.h"
#include "client/view/parts_list_dimensions.h"

namespace prosector {
namespace parts_list_measures {
namespace {

using Kind = PartsSpot::Kind;

constexpr double board_opacity = 0.86, hover_opacity = 0.10, pointed_opacity = 0.28, corner = 4;

class PartsListDrawing {
 public:
  PartsListDrawing(DrawList& out, const PartsList& list) : out_(out), list_(list) {}

  void add_board() {
    out_.plates.push_back({.low = list_.board.min(),
                           .high = list_.board.max(),
                           .color = board_color,
                           .opacity = board_opacity,
                           .radius = corner,
                           .rim_width = 1,
                           .rim_color = rim_color});
    const double head_y = list_.search.min().y() + (search_height - height_of_lines(1) * text_height) / 2;
    list_.state.in_room
        ? write(out_.words.tr("parts"), left() + pad, head_y, list_.search.sizes().x(), dim_writing)
        : add_search(head_y);
    add_reset(head_y);
    for (const PartsList::Line& line : list_.lines)
      line.is_palette ? add_palette(line) : add_row(line, list_.rows[line.row]);
    add_scroll_mark();
    if (list_.state.hovered)
      write(describe_spot(list_, *list_.state.hovered, out_.words), left() + pad,
            list_.lines_area.max().y() + 4, list_.board.sizes().x() - 2 * pad, dim_writing);
  }

 private:
  const Vec3 board_color{0.008, 0.010, 0.014}, field_color{0.03, 0.035, 0.045}, rim_color{0.16, 0.18, 0.2};
  const Vec3 writing{0.85, 0.88, 0.90}, dim_writing{0.34, 0.37, 0.40}, accent{0.95, 0.60, 0.10};

  DrawList& out_;
  const PartsList& list_;

  double left() const { return list_.board.min().x(); }
  double right() const { return list_.board.max().x(); }
  bool is_hovered(const PartsSpot& spot) const { return list_.state.hovered == spot; }

  void write(const std::string& text, double x, double y, double width, const Vec3& color) {
    out_.texts.push_back({.text = text,
                          .at = {x, y, 0},
                          .height = text_height,
                          .color = color,
                          .wrap = width,
                          .least_height = least_text_height,
                          .tallest = 1.001 * height_of_lines(1) * text_height,
                          .ground = TextGround::none});
  }

  void plate(double x, double y, double width, double height, const Vec3& color, double opacity = 1,
             double radius = 0) {
    out_.plates.push_back({.low = {x, y},
                           .high = {x + width, y + height},
                           .color = color,
                           .opacity = opacity,
                           .radius = radius});
  }

  void ring(double x, double y, double width, double height, const Vec3& color, double radius) {
    plate(x, y, width, height, color, 0, radius);
    out_.plates.back().rim_width = 1.5;
    out_.plates.back().rim_color = color;
  }

  void add_search(double y) {
    const PartsListState& state = list_.state;
    out_.plates.push_back({.low = list_.search.min(),
                           .high = list_.search.max(),
                           .color = field_color,
                           .radius = corner,
                           .rim_width = 1,
                           .rim_color = state.typing ? accent : rim_color});
    const bool empty = state.search.empty();
    const std::string shown =
        empty && !state.typing ? out_.words.tr("search") : state.search + (state.typing ? "|" : "");
    write(shown, list_.search.min().x() + 6, y, list_.search.sizes().x() - 12,
          empty && !state.typing ? dim_writing : writing);
  }

  void add_reset(double y) {
    const bool hovered = is_hovered({Kind::reset, 0, 0});
    out_.plates.push_back({.low = list_.reset.min(),
                           .high = list_.reset.max(),
                           .color = field_color,
                           .radius = corner,
                           .rim_width = 1,
                           .rim_color = hovered ? writing : rim_color});
    write(out_.words.tr("reset all"), list_.reset.min().x() + 4, y, reset_width - 8,
          hovered ? writing : dim_writing);
  }

  void add_row(const PartsList::Line& line, const PartRow& row) {
    const double y = line.top;
    const bool hovered = list_.state.hovered && list_.state.hovered->row == line.row &&
                         list_.state.hovered->kind >= Kind::name;
    const bool pointed =
        list_.state.pointed && std::ranges::find(row.bodies, *list_.state.pointed) != row.bodies.end();
    if (pointed) plate(left() + 2, y, right() - left() - 4, line_height, accent, pointed_opacity, corner);
    if (hovered) plate(left() + 2, y, right() - left() - 4, line_height, writing, hover_opacity, corner);
    if (!row.is_head)
      plate(left() + swatch_left, y + (line_height - swatch_size) / 2, swatch_size, swatch_size, row.color, 1,
            3);
    const double text_y = y + (line_height - height_of_lines(1) * text_height) / 2;
    double width = right() - eye_from_right - 4 - left() - name_left;
    if (!row.holders.empty()) {
      width -= holder_width;
      add_holders(row, left() + name_left + width, y, text_y);
    }
    const Vec3 color = row.look.hidden ? dim_writing : row.is_head ? accent : writing;
    const double from = row.is_head ? swatch_left : name_left;
    write(row.text, left() + from, text_y, width + name_left - from, color);
    add_eye(line, row, y + line_height / 2);
    add_target(line, row, y + line_height / 2);
    add_slider(row, y + line_height / 2);
  }

  /// Adds a mark in each holder's colour, and their names.
  void add_holders(const PartRow& row, double x, double y, double text_y) {
    constexpr double mark = 8, gap = 3;
    std::string names;
    for (const PartHolder& holder : row.holders) {
      plate(x + gap, y + (line_height - mark) / 2, mark, mark, holder.color, 1, mark / 2);
      names += (names.empty() ? "" : ", ") + holder.name;
      x += mark + gap;
    }
    const double used = (mark + gap) * static_cast<double>(row.holders.size());
    write(names, x + gap, text_y, std::max(holder_width - used - 2 * gap, 20.0), row.holders.front().color);
  }

  Vec3 mark_color(const PartsList::Line& line, Kind kind, bool bright) const {
    if (is_hovered({kind, line.row, 0})) return accent;
    return bright ? writing : dim_writing;
  }

  /// Adds an eye symbol; without its pupil it is closed.
  void add_eye(const PartsList::Line& line, const PartRow& row, double y) {
    const double x = right() - (eye_from_right + isolate_from_right) / 2;
    const Vec3 color = mark_color(line, Kind::eye, !row.look.hidden);
    if (row.look.hidden) return plate(x - 7, y - 1, 14, 2, color, 1, 1);
    ring(x - 8, y - 5, 16, 10, color, 5);
    plate(x - 2.5, y - 2.5, 5, 5, color, 1, 2.5);
  }

  void add_target(const PartsList::Line& line, const PartRow& row, double y) {
    const double x = right() - (isolate_from_right + slider_from_right) / 2;
    const Vec3 color = row.isolated ? accent : mark_color(line, Kind::isolate, false);
    ring(x - 6, y - 6, 12, 12, color, 6);
    plate(x - 2, y - 2, 4, 4, color, 1, 2);
  }

  void add_slider(const PartRow& row, double y) {
    const double x = right() - slider_from_right + slider_inset;
    const double at = row.look.hidden ? 0 : slider_length * row.look.opacity;
    plate(x, y - 2, slider_length, 4, field_color + Vec3::Constant(0.05), 1, 2);
    if (at <= 0) return;
    plate(x, y - 2, at, 4, row.look.opacity < 1 ? accent : dim_writing, 1, 2);
    plate(x + at - 4, y - 5, 8, 10, writing, 1, 4);
  }

  void add_palette(const PartsList::Line& line) {
    const auto colors = part_colors();
    for (std::size_t k = 0; k <= colors.size(); ++k) {
      const double x = left() + palette_left + palette_step * static_cast<double>(k);
      const bool hovered = is_hovered({Kind::color, line.row, k});
      const double y = line.top + 3, size = line_height - 6;
      if (hovered) ring(x - 2, y - 2, size + 4, size + 4, writing, corner);
      if (k < colors.size())
        plate(x, y, size, size, colors[k].color, 1, 3);
      else
        ring(x, y, size, size, dim_writing, 3);
    }
  }

  void add_scroll_mark() {
    const std::size_t capacity = line_capacity(list_);
    if (list_.all_lines <= capacity) return;
    const double height = list_.lines_area.sizes().y(), all = static_cast<double>(list_.all_lines);
    plate(right() - 4, list_.lines_area.min().y() + height * static_cast<double>(list_.state.first) / all, 3,
          height * static_cast<double>(capacity) / all, dim_writing, 1, 1.5);
  }
};

}  // namespace
}  // namespace parts_list_measures

void add_parts_list(DrawList& out, const PartsList& list) {
  parts_list_measures::PartsListDrawing(out, list).add_board();
}

}  // namespace prosector
