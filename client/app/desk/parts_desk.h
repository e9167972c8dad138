#pragma once
// Mouse and keyboard interaction with the list of parts.

#include <optional>
#include <vector>

#include "client/render/window_context.h"
#include "client/view/parts_list.h"

namespace prosector {

class PartsDesk {
 public:
  PartsDesk() = default;
  /// Creates the state for a list on a board in the room, or for one in a window.
  explicit PartsDesk(bool in_room) { state_.in_room = in_room; }

  /// Processes an event. `pointer`: points from the frame's top left. Returns whether the list consumes the
  /// event.
  bool take(const WindowEvent& event, const Eigen::Vector2d& pointer);
  /// Lays out the list for the next frame of this size (points). `pointed`: the body under the pointer in the
  /// room.
  void lay_out(std::vector<PartRow> rows, std::optional<BodyId> pointed, const Eigen::Vector2d& picture);

  /// Opens the list without starting to type a search, for users without keys; or closes it.
  void toggle_without_search();
  /// Scrolls by lines; negative: backwards.
  void scroll(double lines);

  bool is_open() const { return open_; }
  /// Returns the search text.
  const std::string& search() const { return state_.search; }
  /// Reports whether the pointer operates the list rather than the room.
  bool has_pointer() const { return open_ && (state_.hovered || slides_); }
  /// Returns the list's last layout; null: it is closed.
  const PartsList* shown() const { return open_ && list_ ? &*list_ : nullptr; }
  /// Returns the bodies of the row under the pointer.
  std::vector<BodyId> hovered_bodies() const;

  /// Returns the user's orders since the last call.
  std::vector<PartsOrder> take_orders();
  /// Returns the bodies that the user asked to frame since the last call.
  std::vector<BodyId> take_framed();

 private:
  bool open_ = false;
  PartsListState state_;
  std::optional<PartsList> list_;
  std::optional<std::size_t> slides_;  // row whose slider is dragged
  bool presses_ = false;               // the left button was pressed on the list
  bool opened_by_key_ = false;         // the character of the key that opened it is not typed into the search
  std::vector<PartsOrder> orders_;
  std::vector<BodyId> framed_;

  bool take_key(const KeyEvent& key);
  bool take_escape();
  bool take_typing(Key key);
  void type(char32_t character);
  void toggle_open();
  bool take_button(const MouseButtonEvent& button, const Eigen::Vector2d& pointer);
  void press(const PartsSpot& spot, const Eigen::Vector2d& pointer);
  void follow(const Eigen::Vector2d& pointer);
  void slide(const Eigen::Vector2d& pointer);
  void order(PartsOrder::Kind kind, const PartRow& row);
};

}  // namespace prosector
