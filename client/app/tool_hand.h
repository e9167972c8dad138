#pragma once
// The right hand of a user whose tracked instrument is a blade of the scene. It fetches that blade where it
// lies, brings it over what lies between, and leads it: its tip goes where the instrument's goes.

#include <cstdint>
#include <optional>
#include <string>

#include "client/replica/replica.h"
#include "client/view/blade_frame.h"
#include "common/messages.h"

namespace prosector {

/// What the server tells of the blade and the hand, at one moment. Poses are in the world frame.
struct ToolView {
  BodyId body = 0;
  Pose pose;                  // of the blade's body
  BladeFrame blade;           // in that body's frame
  std::optional<Pose> wrist;  // of the physical hand; nullopt: it isn't there
  bool is_held = false;       // by that hand
  bool is_hindered = false;   // that hand holds something else
};

/// Returns how a hand and the body of that name are now; nullopt: the scene isn't here yet. Throws InputError
/// where it is, and has no blade of that name that moves; says which blades it has.
std::optional<ToolView> see_tool(const Replica& replica, const HandRef& hand, const std::string& name);

class ToolHand {
 public:
  /// Goes on. `instrument`: its tip, +z along the shaft, −y to where the edge is to look; nullopt: it isn't
  /// seen. The hand rests for a while where it was lost, then it is gone. Returns where it is to be.
  HandPose follow(const ToolView& tool, const std::optional<Pose>& instrument, std::int64_t now_ns);
  /// Returns what the hand asked for since the last call: to take hold of the blade, or to let go of what it
  /// holds in its place.
  std::optional<CommandKind> take_wish();
  /// Tells whether it has the user's hand, whatever else sees that.
  bool leads() const { return last_.has_value(); }

 private:
  /// What a moving instrument was seen at.
  struct Seen {
    Pose pose;
    std::int64_t time_ns = 0;
  };

  std::optional<Seen> last_;
  std::optional<Pose> wrist_tool_;  // the blade's body in the wrist's frame, as it is held; nullopt: it isn't
  Pose at_;                         // of the instrument's frame, where the blade is led to now
  bool arrived_ = false;            // the blade goes with the instrument
  std::optional<CommandKind> wish_;
  std::int64_t now_ns_ = 0, wished_ns_ = 0;

  void fetch(const ToolView& tool, HandPose& hand);
  void lead(const ToolView& tool, double seconds, HandPose& hand);
};

}  // namespace prosector
