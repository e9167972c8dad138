#pragma once
// A finger that works a panel.

#include "server/physics/mechanics/panel/panel_world.h"

namespace prosector::test {

inline constexpr double tick = 1.0 / 60;
inline constexpr double finger_radius = 0.008;

/// A segment that points at the board, its tip at `tip` (the lowest point of its ball).
inline panel::Capsule finger_at(const Vec3& tip) {
  const Vec3 end = tip + Vec3(0, 0, finger_radius);
  return {end, end + Vec3(0, 0.004, 0.02), finger_radius};
}

inline std::size_t index_of(PanelControl control) {
  return static_cast<std::size_t>(control);
}

/// Fingertip `height` over the board, over the control's middle.
inline panel::Capsule over(PanelControl control, double height, double position = 0) {
  const Vec3 face = control_face(describe(control), position);
  return finger_at({face.x(), face.y(), height});
}

/// A tip that goes evenly from one place to another in so many ticks.
inline panel::MovedControls move_finger(panel::ControlMotions motions, const Vec3& from, const Vec3& to,
                                        int ticks) {
  panel::MovedControls out{motions, {}};
  for (int i = 1; i <= ticks; ++i) {
    const auto at = [&](int k) { return finger_at(from + (to - from) * (static_cast<double>(k) / ticks)); };
    const panel::FingerSweep sweep{at(i - 1), at(i)};
    const std::bitset<panel_control_count> before = out.touched;
    out = panel::move_controls(out.motions, {&sweep, 1}, tick);
    out.touched |= before;
  }
  return out;
}

/// Nobody there.
inline panel::ControlMotions rest(panel::ControlMotions motions, int ticks) {
  for (int i = 0; i < ticks; ++i) motions = panel::move_controls(motions, {}, tick).motions;
  return motions;
}

inline panel::ControlMotions at_rest() {
  panel::ControlMotions out;
  out[index_of(PanelControl::stiffness)].position = 0.5;
  return out;
}

}  // namespace prosector::test
