#pragma once
// The list of parts on a board in the room, for who has tracked hands and no keyboard. A stretched index
// finger works it as the mouse works the list in a window; drawn along the names it scrolls.

#include <array>
#include <optional>
#include <vector>

#include "client/app/parts_desk.h"
#include "client/view/parts_board_view.h"

namespace prosector {

class PartsBoard {
 public:
  /// Puts the board up beside where the eyes look, on the other side than the hand that asked; or takes it
  /// away.
  void open_or_shut(const Pose& eyes, std::size_t hand);
  bool is_open() const { return desk_.is_open(); }
  /// Lays the rows out for the next picture, and lets the user's fingers work them.
  void follow(std::vector<PartRow> rows, const HandInput& user);
  /// Returns what the user asked for since the last call.
  std::vector<PartsOrder> take_orders() { return desk_.take_orders(); }
  /// Returns the bodies of the row that a finger is at.
  std::vector<BodyId> hovered_bodies() const { return desk_.hovered_bodies(); }
  /// Returns the board as it was laid out last; nullopt: there is none.
  std::optional<PlacedPartsList> shown() const;

 private:
  PartsDesk desk_{true};
  Pose pose_;
  std::array<std::optional<double>, 2> heights_;  // m, of fingertips before the board
  std::optional<std::size_t> worker_;             // the hand that presses
  bool scrolls_ = false;                          // what it presses are names
  double scrolled_from_ = 0;                      // points: where the next line is counted from

  void work(std::size_t hand, const Vec3& tip);
  void press(const Eigen::Vector2d& point);
  void scroll(const Eigen::Vector2d& point);
  void let_go();
};

inline constexpr double pressed_within = 0.004, let_go_beyond = 0.010;  // m, of a tip before the board
inline constexpr double felt_within = 0.05, felt_behind = 0.04;         // m: a tip that is at the board

}  // namespace prosector
