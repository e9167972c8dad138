#pragma once
// Panel inputs of a tick.

#include "common/hand_pose.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/panel_control.h"

namespace prosector::panel {

/// Action of a participant on their own panel (a floating control board of a body) that their client requests
/// directly, without a tracked finger. It is journalled with the tick that processes it.
struct PanelEvent {
  enum class Kind : std::uint8_t {
    open,     // opens the panel of part `body`, and closes the participant's other panel
    close,    // also when the owner leaves or may no longer touch
    set,      // sets `control` of the open panel to `value`: button 0 off, 1 on; slider 0 … 1
    put,      // moves the panel's centre to `at`, unless a fist carries it
    put_back  // moves the panel to its initial pose, unless a fist carries it
  } kind = Kind::open;
  ParticipantId participant = 0;
  BodyId body = 0;
  PanelControl control = PanelControl::attach;
  double value = 0;
  Vec3 at = Vec3::Zero();  // m, world frame
};
inline constexpr PanelEvent::Kind last_panel_event = PanelEvent::Kind::put_back;

/// Position and facing direction of a participant's head, to which their panels (floating control boards)
/// turn.
struct HeadPlace {
  ParticipantId participant = 0;
  Vec3 at = Vec3::Zero();     // m, world frame
  Vec3 ahead = Vec3::Zero();  // unit, horizontal: direction that the face points to, at any pitch; 0: unknown
};

/// Pose of a tablet or stylus that a participant holds. A device for which no new pose is received keeps its
/// last one.
struct HeldPlace {
  ParticipantId participant = 0;
  HeldObject thing = HeldObject::tablet;
  bool seen = true;  // false: no longer tracked, `at` is invalid
  Pose at;           // tablet: pose of its panel; stylus: pose of its tip, +z along the shaft; world frame
};

}  // namespace prosector::panel
