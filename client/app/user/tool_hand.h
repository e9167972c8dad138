#pragma once
// Right hand of a user whose tracked instrument controls a blade of the scene. The hand fetches the blade,
// carries it over obstacles to the instrument, and then moves it so that both tips coincide.

#include <cstdint>
#include <optional>
#include <string>

#include "client/replica/replica.h"
#include "client/view/blade_frame.h"
#include "common/commands.h"
#include "common/hand_pose.h"
#include "common/ids.h"
#include "common/math.h"

namespace prosector {

/// State, on the server at one time, of the blade that the user's tracked instrument controls, and of the
/// simulated hand. Poses are in the world frame.
struct ToolState {
  BodyId body = 0;
  Pose pose;                  // pose of the blade's body
  BladeFrame blade;           // in the body's frame
  std::optional<Pose> wrist;  // pose of the simulated hand; nullopt: it is absent
  bool is_held = false;       // held by that hand
  bool is_hindered = false;   // that hand holds another body
};

/// Returns the state of a hand and of the blade with this name; nullopt if the scene has not arrived yet.
/// Throws InputError, with the names of the available blades, if the scene has no movable blade of this name.
std::optional<ToolState> tool_state(const Replica& replica, const HandRef& hand, const std::string& name);

class ToolHand {
 public:
  /// Advances to `now_ns` (monotonic clock) and returns the target pose of the hand, which fetches the blade
  /// and then moves its tip to that of the instrument. `instrument`: pose with its tip as origin, +z along
  /// the shaft, −y towards the edge; nullopt: not tracked. Without the instrument the hand rests for a while,
  /// then becomes untracked.
  HandPose follow(const ToolState& tool, const std::optional<Pose>& instrument, std::int64_t now_ns);
  /// Returns the command to the server requested since the last call: to grasp the blade, or to release
  /// another held body; nullopt if there is none.
  std::optional<CommandBody> take_command();
  /// Returns whether the tracked instrument controls the user's hand, overriding other trackers.
  bool leads() const { return last_.has_value(); }

 private:
  /// Pose and time of the last tracking result of the instrument.
  struct Seen {
    Pose pose;
    std::int64_t time_ns = 0;
  };

  std::optional<Seen> last_;
  std::optional<Pose> wrist_tool_;  // pose of the held blade's body in the wrist frame; nullopt: not held
  Pose at_;                         // present target of the blade, as a pose of the instrument frame
  bool arrived_ = false;            // the blade follows the instrument directly
  std::optional<CommandBody> wish_;
  std::int64_t now_ns_ = 0, wished_ns_ = 0;

  void fetch(const ToolState& tool, HandPose& hand);
  void lead(const ToolState& tool, double seconds, HandPose& hand);
};

}  // namespace prosector
