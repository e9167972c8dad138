#pragma once
// Messages about parts of the anatomy, their panels, and what all participants share of the room.

#include <array>
#include <vector>

#include "common/ids.h"
#include "common/math.h"
#include "common/panel_control.h"

namespace prosector {

/// Message from the server to all clients: the changes that participants made to a body, and the hands that
/// hold it. Reliable, transient-local, keyed by body. It is sent when they change, and never for an unchanged
/// body.
struct PartState {
  BodyId body = 0;
  SimTime time;
  bool attached = true;    // attached to its place in the anatomy
  bool hidden = false;     // neither visible nor touchable
  bool lit = false;        // the lamp shines on it
  bool inspected = false;  // shown as transformed by `shape`, and not touchable
  double opacity = 1;      // 0 … 1
  double stiffness = 1;    // factor on the scene's stiffness
  Affine shape;
  std::vector<HandRef> holders;  // ascending
};

inline constexpr double max_shape_entry = 100;  // largest entry of an inspected part's linear map

/// Message from the server to all clients: the control panel of an anatomical part, which is the same for all
/// participants. Reliable, transient-local, keyed by the participant that opened the panel.
struct Panel {
  ParticipantId participant = 0;
  SimTime time;
  bool open = false;
  BodyId body = 0;
  Pose pose;  // pose of its centre in the room frame: +z towards the reader, +y up
  std::array<ControlState, panel_control_count> controls{};
};

/// Message from the server to all clients: the room's lights and the pace of simulated time, which all
/// participants share. Reliable, transient-local.
struct RoomState {
  SimTime time;
  double lights = 1;  // brightness of all lights except lamps that bodies carry, 0 … 1
  double pace = 1;    // simulated seconds per real second, as set by the host; 0: paused
};

}  // namespace prosector
