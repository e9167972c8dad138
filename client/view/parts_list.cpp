#include "client/view/parts_list.h"

#include <algorithm>

#include "client/view/overlay_frame.h"
#include "client/view/parts_list_dimensions.h"

namespace prosector {
namespace parts_list_measures {
namespace {

Eigen::AlignedBox2d box(double left, double top, double right, double bottom) {
  return {Eigen::Vector2d(left, top), Eigen::Vector2d(right, bottom)};
}

std::vector<PartsList::Line> lines_of(const PartsList& list) {
  std::vector<PartsList::Line> out;
  for (std::size_t row = 0; row < list.rows.size(); ++row) {
    out.push_back({row, false, 0});
    if (list.state.palette == list.rows[row].text) out.push_back({row, true, 0});
  }
  return out;
}

PartsSpot spot_in(const PartsList& list, const PartsList::Line& line, double x) {
  using Kind = PartsSpot::Kind;
  const double right = list.board.max().x(), left = list.board.min().x();
  if (line.is_palette) {
    const double at = (x - left - palette_left) / palette_step;
    if (at < 0 || at >= static_cast<double>(part_colors().size()) + 1) return {Kind::board, line.row, 0};
    return {Kind::color, line.row, static_cast<std::size_t>(at)};
  }
  if (x < left + name_left) return {Kind::swatch, line.row, 0};
  if (x < right - eye_from_right) return {Kind::name, line.row, 0};
  if (x < right - isolate_from_right) return {Kind::eye, line.row, 0};
  if (x < right - slider_from_right) return {Kind::isolate, line.row, 0};
  return {Kind::slider, line.row, 0};
}

}  // namespace
}  // namespace parts_list_measures

PartsList lay_out_parts(std::vector<PartRow> rows, PartsListState state, const Eigen::Vector2d& picture) {
  using namespace parts_list_measures;
  PartsList list{std::move(state), std::move(rows), {}, {}, {}, {}, {}, 0};
  const double right = picture.x() - parts_list_gap, left = std::max(right - parts_list_width, 0.0);
  std::vector<PartsList::Line> all = lines_of(list);
  list.all_lines = all.size();
  const double top = parts_list_gap, head = search_height + 2 * pad;
  const double full = top + head + line_height * (static_cast<double>(all.size()) + 0.5) + hint_height;
  const double bottom = std::max(std::min(picture.y() - message_band - parts_list_gap, full), top);
  list.board = box(left, top, right, bottom);
  list.search = box(left + pad, top + pad, right - pad - reset_width - pad, top + pad + search_height);
  list.reset = box(right - pad - reset_width, top + pad, right - pad, top + pad + search_height);
  list.lines_area = box(left, top + head, right, bottom - hint_height);
  const std::size_t capacity = line_capacity(list);
  list.state.first = std::min(list.state.first, all.size() - std::min(capacity, all.size()));
  for (std::size_t k = 0; k < capacity && list.state.first + k < all.size(); ++k) {
    PartsList::Line line = all[list.state.first + k];
    line.top = list.lines_area.min().y() + line_height * static_cast<double>(k);
    list.lines.push_back(line);
  }
  return list;
}

std::size_t line_capacity(const PartsList& list) {
  return static_cast<std::size_t>(
      std::max(list.lines_area.sizes().y() / parts_list_measures::line_height, 0.0));
}

std::optional<PartsSpot> spot_at(const PartsList& list, const Eigen::Vector2d& point) {
  if (!list.board.contains(point)) return std::nullopt;
  if (list.search.contains(point)) return PartsSpot{PartsSpot::Kind::search, 0, 0};
  if (list.reset.contains(point)) return PartsSpot{PartsSpot::Kind::reset, 0, 0};
  for (const PartsList::Line& line : list.lines)
    if (point.y() >= line.top && point.y() < line.top + parts_list_measures::line_height)
      return parts_list_measures::spot_in(list, line, point.x());
  return PartsSpot{};
}

double slider_opacity(const PartsList& list, const Eigen::Vector2d& point) {
  using namespace parts_list_measures;
  const double from = list.board.max().x() - slider_from_right + slider_inset;
  return std::clamp((point.x() - from) / slider_length, least_opacity, 1.0);
}

void scroll_to(PartsListState& state, const PartsList& list, std::size_t row) {
  const auto all = parts_list_measures::lines_of(list);
  const auto found =
      std::ranges::find_if(all, [&](const PartsList::Line& l) { return l.row == row && !l.is_palette; });
  if (found == all.end()) return;
  const auto line = static_cast<std::size_t>(found - all.begin()), capacity = line_capacity(list);
  if (line < state.first) state.first = line;
  if (line >= state.first + capacity) state.first = line + 1 - capacity;
}

std::string describe_spot(const PartsList& list, const PartsSpot& spot, const Catalogue& words) {
  using Kind = PartsSpot::Kind;
  if (spot.kind == Kind::search)
    return list.state.in_room ? "" : words.tr("find parts by name or number, in any language");
  if (spot.kind == Kind::reset) return words.tr("reset all parts to the scene's state");
  if (spot.kind == Kind::board || spot.row >= list.rows.size()) return "";
  const PartRow& row = list.rows[spot.row];
  if (spot.kind == Kind::name && list.state.in_room) return words.tr("drag along the names to scroll");
  if (spot.kind == Kind::name) return row.is_head ? "" : words.tr("fits the part into the view");
  if (spot.kind == Kind::eye && row.is_head)
    return row.look.hidden ? words.tr("shows all of them") : words.tr("hides all of them");
  if (spot.kind == Kind::eye) return row.look.hidden ? words.tr("shows it") : words.tr("hides it");
  if (spot.kind == Kind::isolate)
    return row.isolated ? words.tr("hides or shows the other parts") : words.tr("fades the others");
  if (spot.kind == Kind::slider) return words.tr("opacity: {:.0f} %", 100 * row.look.opacity);
  if (spot.kind == Kind::swatch)
    return row.is_head ? words.tr("sets the colour of all its parts") : words.tr("sets its colour");
  const auto colors = part_colors();
  return spot.color < colors.size() ? words.tr(std::string(colors[spot.color].name))
                                    : words.tr("original colour");
}

}  // namespace prosector
