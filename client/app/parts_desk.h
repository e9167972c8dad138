#pragma once
// How mouse and keyboard work the list of parts.

#include <optional>
#include <vector>

#include "client/render/window_context.h"
#include "client/view/parts_list.h"

namespace prosector {

class PartsDesk {
 public:
  PartsDesk() = default;
  /// Makes it for a list on a board in the room, or for one in a window.
  explicit PartsDesk(bool in_room) { state_.in_room = in_room; }

  /// Takes an event, with the pointer's place (points from the picture's top left). Returns whether the list
  /// keeps it to itself.
  bool take(const WindowEvent& event, const Eigen::Vector2d& pointer);
  /// Lays the list out for the next picture of that size (points). `pointed` is what the pointer is at in the
  /// room.
  void lay_out(std::vector<PartRow> rows, std::optional<BodyId> pointed, const Eigen::Vector2d& picture);

  /// Opens the list for who has no keys, so without its search being typed; or shuts it.
  void open_or_shut_by_hand();
  /// Moves on by lines, backwards where they are below 0.
  void scroll(double lines);

  bool is_open() const { return open_; }
  /// Returns what the list is to be searched for.
  const std::string& search() const { return state_.search; }
  /// Tells whether the pointer works the list rather than the room.
  bool has_pointer() const { return open_ && (state_.hovered || slides_); }
  /// Returns the list as it was laid out last; null: it is shut.
  const PartsList* shown() const { return open_ && list_ ? &*list_ : nullptr; }
  /// Returns the bodies of the row that the pointer is at.
  std::vector<BodyId> hovered_bodies() const;

  /// Returns what the user asked for since the last call.
  std::vector<PartsOrder> take_orders();
  /// Returns the bodies that are to be brought into the picture since the last call.
  std::vector<BodyId> take_framed();

 private:
  bool open_ = false;
  PartsListState state_;
  std::optional<PartsList> list_;
  std::optional<std::size_t> slides_;  // row whose slider is held
  bool presses_ = false;               // the left button went down on the list
  bool opened_by_key_ = false;         // the key's own character is no search
  std::vector<PartsOrder> orders_;
  std::vector<BodyId> framed_;

  bool take_key(const KeyEvent& key);
  bool take_escape();
  bool take_typing(Key key);
  void type(char32_t character);
  void open_or_shut();
  bool take_button(const MouseButtonEvent& button, const Eigen::Vector2d& pointer);
  void press(const PartsSpot& spot, const Eigen::Vector2d& pointer);
  void follow(const Eigen::Vector2d& pointer);
  void slide(const Eigen::Vector2d& pointer);
  void order(PartsOrder::Kind kind, const PartRow& row);
};

}  // namespace prosector
