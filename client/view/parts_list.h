#pragma once
// The list of parts in a picture: where each of its controls is, and how it is drawn.

#include <optional>

#include "client/view/draw_list.h"
#include "client/view/parts_rows.h"

namespace prosector {

/// What can be pointed at in the list.
struct PartsSpot {
  enum class Kind : std::uint8_t { board, search, reset, name, eye, isolate, slider, swatch, color };
  Kind kind = Kind::board;
  std::size_t row = 0;    // of all but board, search and reset
  std::size_t color = 0;  // of `color`: of part_colors(), and after them the part's own
  bool operator==(const PartsSpot&) const = default;
};

/// What the user did to the list.
struct PartsListState {
  std::string search;                       // UTF-8
  bool typing = false;                      // keys go into the search
  bool in_room = false;                     // on a board that a fingertip works, without keys
  std::size_t first = 0;                    // line of the rows that is at the top
  std::optional<std::string> palette = {};  // text of the row whose colours are open
  std::optional<PartsSpot> hovered = {};
  std::optional<BodyId> pointed = {};  // at in the room
};

/// The list as it stands in a picture, in points from the picture's top left.
struct PartsList {
  /// A row, or the colours to choose from below it.
  struct Line {
    std::size_t row = 0;
    bool is_palette = false;
    double top = 0;
  };
  PartsListState state;
  std::vector<PartRow> rows;
  Eigen::AlignedBox2d board, search, reset, lines_area;
  std::vector<Line> lines;  // those that are seen
  std::size_t all_lines = 0;
};

inline constexpr double parts_list_width = 320, parts_list_gap = 10;  // points, at the right border

/// Lays the list out at the right border of a picture of that size (points), clear of the messages. Scrolling
/// is kept within what there is.
PartsList lay_out_parts(std::vector<PartRow> rows, PartsListState state, const Eigen::Vector2d& picture);

/// Returns how many lines there is room for.
std::size_t line_capacity(const PartsList& list);

/// Returns what is at a point; nullopt: not the list.
std::optional<PartsSpot> spot_at(const PartsList& list, const Eigen::Vector2d& point);

/// Returns the opacity that a point on the row's slider stands for.
double slider_opacity(const PartsList& list, const Eigen::Vector2d& point);

/// Scrolls, if need be, until the row is seen.
void scroll_to(PartsListState& state, const PartsList& list, std::size_t row);

/// Returns, in words, what a click there does; empty: nothing.
std::string told_spot(const PartsList& list, const PartsSpot& spot, const Catalogue& words = {});

/// Adds the list to a picture.
void add_parts_list(DrawList& out, const PartsList& list);

}  // namespace prosector
