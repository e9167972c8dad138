#pragma once
// How a desk user's hand carries a blade over tissue between cuts.

#include "client/app/desk/desk_wrist.h"
#include "client/app/desk/hand_guide.h"
#include "common/math.h"

namespace prosector {

inline constexpr double lookahead_distance = 0.08;  // m ahead of the tip, in which surfaces are looked for

/// Carries a blade clear of tissue, and sets it upright on its tip after it was grasped in a lying position.
class BladeCarry {
 public:
  /// Handles that the blade was put down.
  void put_down() { upright_ = false; }
  bool is_upright() const { return upright_; }
  /// Rotates the wrist until the tip of the guide's blade points down and its edge to the right. Rotates only
  /// while the blade is clear of tissue and the simulated hand is near `target`, the position of the wrist
  /// (m, world frame).
  void set_upright(const HandGuide& guide, const Vec3& target, DeskWrist& wrist, double seconds);
  /// Returns the next target of the tip on its way from `from` to `to` (m, world frame), high enough to pass
  /// over surfaces in between. `pressed`: the button is pressed. The guide must have `find`.
  Vec3 over_tissue(const HandGuide& guide, const Vec3& from, const Vec3& to, bool pressed);

 private:
  double over_ground_ = 0;  // m, height of the tip over the highest surface on its path
  bool upright_ = false;    // the blade was set upright on its tip since it was grasped
};

}  // namespace prosector
