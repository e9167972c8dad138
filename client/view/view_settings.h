#pragma once
// The viewer of a session and the view's settings.

#include <optional>
#include <string>
#include <vector>

#include "client/language/catalogue.h"
#include "client/view/outlook.h"
#include "client/view/parts_board_view.h"
#include "client/view/time_bar.h"
#include "common/hand_messages.h"
#include "common/ids.h"

namespace prosector {

struct ViewSettings : Outlook {
  Catalogue words = {};  // language of the overlays
  double detail = 0;     // pixels of tolerated error, for LevelOfDetail::choose()
  bool overlay = true;
  std::vector<std::string> messages = {};           // lines at the lower border, the oldest first
  PartsChoice parts = {};                           // how the viewer sees the parts
  std::optional<PlacedPartsList> parts_board = {};  // list of parts on a board in the room
  std::optional<WatchedTime> time = {};             // playback state of the recording
  std::vector<std::string> insets;  // names of users whose views are shown as insets, where they fit
};

/// Local user at the current state of the input devices: participant, hands and head.
struct LocalUser {
  ParticipantId participant = 0;
  HandInput input;
  bool present = false;  // false: an observer without hands
  /// Whether the user moves the hand with a pointer and has no haptics. The hand is then drawn at its
  /// simulated pose, with a half-transparent ghost at the pose that the pointer sets, and with depth cues.
  bool at_desk = false;
};

}  // namespace prosector
