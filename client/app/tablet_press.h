#pragma once
// How a bare hand works a tablet before one camera. Its depth is off by some 2 cm, where a button's way is
// 7 mm. The direction in which the camera sees its fingertip is known well, and so is the board
// (docs/decisions/0031). So a pointing finger is where its ray meets the board. It presses what it stays at,
// and lets go of that when it goes elsewhere or no longer points.

#include <array>
#include <cstdint>
#include <optional>

#include "common/messages.h"

namespace prosector {

class TabletPress {
 public:
  /// Returns the hand as it works the tablet: moved along the ray from `eye` (m, room) through the tip of its
  /// index finger. Before the board a hand that doesn't point is kept off it. Others stay where they are
  /// seen.
  HandPose follow(std::size_t hand, const HandPose& seen, const Pose& tablet, const Vec3& eye,
                  std::int64_t time_ns);
  /// Notes that this hand is out of sight: what its finger pressed is let go.
  void lose(std::size_t hand) { fingers_[hand] = {}; }

  static constexpr double dwell = 0.5;  // s that a finger stays at a control until it presses

 private:
  /// A finger before the board.
  struct Finger {
    std::optional<PanelControl> control;  // that it is at
    std::int64_t since_ns = 0;
    Vec3 first = Vec3::Zero();  // m, on the board: where it came to rest
    bool presses = false;
  };
  void aim(Finger& finger, const Vec3& at, std::int64_t time_ns);

  std::array<Finger, 2> fingers_;
};

}  // namespace prosector
