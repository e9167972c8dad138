#pragma once
// The list of parts in a view: layout, hit test and drawing.

#include <optional>

#include "client/view/draw_list.h"
#include "client/view/parts_rows.h"

namespace prosector {

/// Control of the list of parts to which the user can point, and the row that it is in.
struct PartsSpot {
  enum class Kind : std::uint8_t { board, search, reset, name, eye, isolate, slider, swatch, color };
  Kind kind = Kind::board;
  std::size_t row = 0;    // for all kinds but board, search and reset
  std::size_t color = 0;  // for `color`: index of part_colors(); its size means the part's own colour
  bool operator==(const PartsSpot&) const = default;
};

/// State of the user's interaction with the list of parts: search text, scroll position, and what the pointer
/// is on.
struct PartsListState {
  std::string search;                       // UTF-8
  bool typing = false;                      // keys are typed into the search field
  bool in_room = false;                     // on a board operated by a fingertip, without keys
  std::size_t first = 0;                    // first visible line of the rows
  std::optional<std::string> palette = {};  // text of the row whose colour palette is open
  std::optional<PartsSpot> hovered = {};
  std::optional<BodyId> pointed = {};  // in the room
};

/// Layout of the list of parts in a view: its rows and their positions, in points from the view's top left.
struct PartsList {
  /// Visible line of the list of parts: a row, or the colour palette below a row.
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

/// Returns the layout of the list of parts at the right border of a view, above the message lines. `picture`:
/// width and height of the view, points. The scroll position in `state` is limited to the existing lines.
PartsList lay_out_parts(std::vector<PartRow> rows, PartsListState state, const Eigen::Vector2d& picture);

/// Returns the number of lines that the list of parts can show without scrolling.
std::size_t line_capacity(const PartsList& list);

/// Returns the control of the list of parts at a position of the view, in points from the top left; nullopt
/// outside the list.
std::optional<PartsSpot> spot_at(const PartsList& list, const Eigen::Vector2d& point);

/// Returns the opacity, 0 … 1, that a row's slider has if its knob is moved to this position (points from the
/// view's top left).
double slider_opacity(const PartsList& list, const Eigen::Vector2d& point);

/// Changes the list's scroll position in `state`, if needed, so that the row becomes visible.
void scroll_to(PartsListState& state, const PartsList& list, std::size_t row);

/// Returns a text that describes what a click on the control of the list of parts does; empty if it does
/// nothing.
std::string describe_spot(const PartsList& list, const PartsSpot& spot, const Catalogue& words = {});

/// Adds the list of parts to the overlay of a view, at the positions of its layout.
void add_parts_list(DrawList& out, const PartsList& list);

}  // namespace prosector
