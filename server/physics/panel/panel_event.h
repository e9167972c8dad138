#pragma once
// What a tick consumes for panels.

#include "common/messages.h"

namespace prosector {

/// What somebody does to their own panel without a finger; journalled with the tick it is consumed in.
struct PanelEvent {
  enum class Kind : std::uint8_t {
    open,     // of the part `body`; another one that is open closes
    close,    // also when its owner leaves, or may no longer touch
    set,      // of the open panel: `control` to `value`: button 0 off, 1 on; slider 0 … 1
    put,      // its middle goes to `at`, unless a fist carries it
    put_back  // to where it came up, unless a fist carries it
  } kind = Kind::open;
  ParticipantId participant = 0;
  BodyId body = 0;
  PanelControl control = PanelControl::attach;
  double value = 0;
  Vec3 at = Vec3::Zero();  // m, world frame
};
inline constexpr PanelEvent::Kind last_panel_event = PanelEvent::Kind::put_back;

/// Where somebody's eyes are: their panels face them.
struct HeadPlace {
  ParticipantId participant = 0;
  Vec3 at = Vec3::Zero();     // m, world frame
  Vec3 ahead = Vec3::Zero();  // level unit vector: which way they face, however steeply they look; 0: unknown
};

/// Where somebody's tablet or stylus is. Who isn't told of anew is still there.
struct HeldPlace {
  ParticipantId participant = 0;
  HeldThing thing = HeldThing::tablet;
  bool seen = true;  // false: no longer tracked; `at` says nothing
  Pose at;           // of the panel that it is, or of its tip with +z along its shaft; world frame
};

}  // namespace prosector
