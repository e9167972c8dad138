#pragma once
// The list of parts in a view: layout, hit test and drawing.

#include <optional>

#include "client/view/draw_list.h"
#include "client/view/parts_rows.h"

namespace prosector {

/// A control of the list that can be pointed at.
struct PartsSpot {
  enum class Kind : std::uint8_t { board, search, reset, name, eye, isolate, slider, swatch, color };
  Kind kind = Kind::board;
  std::size_t row = 0;    // for all kinds but board, search and reset
  std::size_t color = 0;  // for `color`: index of part_colors(); its size means the part's own colour
  bool operator==(const PartsSpot&) const = default;
};

/// The user's interaction with the list.
struct PartsListState {
  std::string search;                       // UTF-8
  bool typing = false;                      // keys are typed into the search field
  bool in_room = false;                     // on a board operated by a fingertip, without keys
  std::size_t first = 0;                    // first visible line of the rows
  std::optional<std::string> palette = {};  // text of the row whose colour palette is open
  std::optional<PartsSpot> hovered = {};
  std::optional<BodyId> pointed = {};  // in the room
};

/// Layout of the list in a view, in points from the view's top left.
struct PartsList {
  /// A row, or the colour palette below it.
  struct Line {
    std::size_t row = 0;
    bool is_palette = false;
    double top = 0;
  };
  PartsListState state;
  std::vector<PartRow> rows;
  Eigen::AlignedBox2d board, search, reset, lines_area;
  std::vector<Line> lines;  // the visible ones
  std::size_t all_lines = 0;
};

inline constexpr double parts_list_width = 320, parts_list_gap = 10;  // points, at the right border

/// Lays out the list at the right border of a view of the given size (points), above the messages. Clamps the
/// scroll position.
PartsList lay_out_parts(std::vector<PartRow> rows, PartsListState state, const Eigen::Vector2d& picture);

/// Returns how many lines fit.
std::size_t line_capacity(const PartsList& list);

/// Returns the control at a point; nullopt: outside the list.
std::optional<PartsSpot> spot_at(const PartsList& list, const Eigen::Vector2d& point);

/// Returns the opacity at a point of the row's slider.
double slider_opacity(const PartsList& list, const Eigen::Vector2d& point);

/// Scrolls, if needed, until the row is visible.
void scroll_to(PartsListState& state, const PartsList& list, std::size_t row);

/// Returns a description of what a click on the control does; empty: nothing.
std::string describe_spot(const PartsList& list, const PartsSpot& spot, const Catalogue& words = {});

/// Adds the list to a view.
void add_parts_list(DrawList& out, const PartsList& list);

}  // namespace prosector
