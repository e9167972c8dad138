#pragma once
// List of parts on a board in the room, for users with tracked hands and no keyboard. A stretched index
// finger operates it like the mouse operates the list in a window; drawn along the names it scrolls.

#include <array>
#include <optional>
#include <vector>

#include "client/app/desk/parts_desk.h"
#include "client/view/parts_board_view.h"

namespace prosector {

class PartsBoard {
 public:
  /// Opens the board with the list of parts next to the viewing direction, on the side opposite to the hand
  /// that made the gesture; closes it if it is open. `eyes`: pose of the user's eyes, room frame.
  void toggle_open(const Pose& eyes, std::size_t hand);
  bool is_open() const { return desk_.is_open(); }
  /// Lays out the rows on the board for the next frame, and processes the user's fingertips, which press
  /// controls and scroll.
  void follow(std::vector<PartRow> rows, const HandInput& user);
  /// Returns and removes the commands on the display of parts that the user has given on the board since the
  /// last call.
  std::vector<PartsOrder> take_orders() { return desk_.take_orders(); }
  /// Returns the bodies of the part in whose row a fingertip is; empty if there is none.
  std::vector<BodyId> hovered_bodies() const { return desk_.hovered_bodies(); }
  /// Returns the last layout of the list of parts with the pose of the board; nullopt if the board is closed.
  std::optional<PlacedPartsList> shown() const;

 private:
  PartsDesk desk_{true};
  Pose pose_;
  std::array<std::optional<double>, 2> heights_;  // m, distance of fingertips in front of the board
  std::optional<std::size_t> worker_;             // the hand that presses
  bool scrolls_ = false;      // the pressed point scrolls: names, or the board's background
  double scrolled_from_ = 0;  // points: position from which the next line is counted

  void work(std::size_t hand, const Vec3& tip);
  void press(const Eigen::Vector2d& point);
  void scroll(const Eigen::Vector2d& point);
  void let_go();
};

inline constexpr double press_distance = 0.004,
                        release_distance =
                            0.010;  // m: distances of a tip from the board at which it presses and releases
inline constexpr double
    felt_within = 0.05,
    felt_behind = 0.04;  // m: distances in front of and behind the board within which a tip operates it

}  // namespace prosector
