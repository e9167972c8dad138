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
  /// Creates the interaction state of a closed list of parts: one on a board in the room, which fingertips
  /// operate, or one in a window.
  explicit PartsDesk(bool in_room) { state_.in_room = in_room; }

  /// Processes an input event for the list of parts. `pointer`: points from the frame's top left. Returns
  /// whether the list consumes the event, so that nothing else must react to it.
  bool take(const WindowEvent& event, const Eigen::Vector2d& pointer);
  /// Lays out the list of parts for the next frame. `picture`: width and height of the frame, points.
  /// `pointed`: the body under the pointer in the room, whose row is marked; nullopt: none.
  void lay_out(std::vector<PartRow> rows, std::optional<BodyId> pointed, const Eigen::Vector2d& picture);

  /// Opens the list of parts without starting to type a search, for users without keys; closes it if it is
  /// open.
  void toggle_without_search();
  /// Scrolls the list of parts by this number of lines; negative: towards the beginning.
  void scroll(double lines);

  bool is_open() const { return open_; }
  /// Returns the text in the search field of the list of parts, UTF-8.
  const std::string& search() const { return state_.search; }
  /// Returns whether the pointer operates the list of parts rather than the room.
  bool has_pointer() const { return open_ && (state_.hovered || slides_); }
  /// Returns the last layout of the list of parts; null if the list is closed.
  const PartsList* shown() const { return open_ && list_ ? &*list_ : nullptr; }
  /// Returns the bodies of the part in whose row the pointer is; empty if there is none.
  std::vector<BodyId> hovered_bodies() const;

  /// Returns and removes the commands on the display of parts that the user has given with the list since the
  /// last call.
  std::vector<PartsOrder> take_orders();
  /// Returns and removes the bodies that the user has asked, since the last call, to be moved into the middle
  /// of the view.
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
