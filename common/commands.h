#pragma once
// Commands of participants to the server: a struct for each. Its `name` is the command's name in
// summary.json and in docs. Refusals and guards: server/session/people/session_commands.cpp. Wire form:
// idl/wire/command_wire.cpp.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "common/ids.h"
#include "common/math.h"
#include "common/panel_control.h"
#include "common/panel_placement.h"

namespace prosector {

/// Command of a client to be admitted to the session.
struct Join {
  static constexpr std::string_view name = "join";
};

/// Command to grasp a body with a hand: the nearest rigid body that the hand can hold, otherwise the nearest
/// tissue.
struct Grasp {
  static constexpr std::string_view name = "grasp";
  std::uint8_t hand = right_hand;
  std::optional<BodyId> body = {};  // grasped rather than the nearest one, if it is within reach
};

/// Command to release the body that a hand holds.
struct Release {
  static constexpr std::string_view name = "release";
  std::uint8_t hand = right_hand;
};

/// Command to put a body back to its initial state in the scene, at rest.
struct ResetBody {
  static constexpr std::string_view name = "reset";
  BodyId body = 0;
  std::uint8_t hand = right_hand;  // whose gesture requested it; journalled only
};

/// Command of a participant to leave the session.
struct Leave {
  static constexpr std::string_view name = "leave";
};

/// Command of the host to assign a role to a participant. A host that assigns the host's role to another
/// participant becomes a dissector.
struct SetRole {
  static constexpr std::string_view name = "set_role";
  ParticipantId subject = 0;  // participant that gets the role
  Role role = Role::observer;
};

/// Command to detach an anatomical part from its place in the anatomy, so that it can be moved.
struct Detach {
  static constexpr std::string_view name = "detach";
  BodyId body = 0;
};

/// Command to attach a detached anatomical part again at its place, if it is near enough to it.
struct Attach {
  static constexpr std::string_view name = "attach";
  BodyId body = 0;
};

/// Command to inspect a body: it is displayed moved, rotated, scaled or sheared, and nothing touches it
/// meanwhile.
struct Inspect {
  static constexpr std::string_view name = "inspect";
  BodyId body = 0;
  Affine shape = {};  // from the position of a point of the body to where it is displayed, m, world frame
};

/// Command to end the inspection of a body, which is then displayed unchanged again.
struct EndInspect {
  static constexpr std::string_view name = "end_inspect";
  BodyId body = 0;
};

/// Command to open the control panel of an anatomical part, as a touch of the part does, or to move the
/// sender's open panel.
struct OpenPanel {
  static constexpr std::string_view name = "open_panel";
  BodyId body = 0;
  PanelPlacement placing = PanelPlacement::stays;
  Vec3 at = Vec3::Zero();  // m, world frame: the panel's new centre, for PanelPlacement::put
};

/// Command to close the sender's control panel.
struct ClosePanel {
  static constexpr std::string_view name = "close_panel";
};

/// Command to set a control (button or slider) of the sender's open panel, as a finger does.
struct SetControl {
  static constexpr std::string_view name = "set_control";
  PanelControl control = PanelControl::attach;
  double value = 0;  // button: 0 off, 1 on; slider: 0 … 1
};

/// Command to undo the sender's last cut.
struct Undo {
  static constexpr std::string_view name = "undo";
};

/// Command of the host to rewind the whole scene to the time at which a body got a certain topology revision.
struct Rewind {
  static constexpr std::string_view name = "rewind";
  BodyId body = 0;
  std::uint32_t revision = 0;  // of the body
};

/// Command of a client to send the complete topology of a body, because the client's copy doesn't match the
/// server's log.
struct RequestKeyframe {
  static constexpr std::string_view name = "keyframe";
  BodyId body = 0;
};

/// Command to set the pace of simulated time. It may be sent by the host or, in a recording without a host,
/// by anyone.
struct SetPace {
  static constexpr std::string_view name = "set_pace";
  double pace = 0;  // simulated seconds per real second: 0 stops time, else min_pace … 1, or … max_pace
};
inline constexpr double min_pace = 1.0 / 64, max_pace = 8;  // above 1: in recordings only

/// Command to stop simulated time after a number of further ticks. It may be sent by the host or, in a
/// recording without a host, by anyone.
struct StepTicks {
  static constexpr std::string_view name = "step_ticks";
  std::uint32_t ticks = 0;  // 1 … most_steps
};
inline constexpr std::uint32_t most_steps = 6000;

/// Command of the host to restore the state with which the server began.
struct ResetAll {
  static constexpr std::string_view name = "reset_all";
};

/// Command of a viewer to continue the playback of a recording at another time.
struct Seek {
  static constexpr std::string_view name = "seek";
  std::uint32_t tick = 0;  // whose end is shown
};

inline constexpr std::uint32_t max_steps_down = 3;

/// Command of the host to set how exactly a body is solved from now on.
struct SetEffort {
  static constexpr std::string_view name = "set_effort";
  BodyId body = 0;
  std::uint32_t steps_down = 0;  // 0, as described, to max_steps_down
};

/// Command of the host to set how exactly all soft bodies are solved from now on.
struct SetAllEfforts {
  static constexpr std::string_view name = "set_all_efforts";
  std::uint32_t steps_down = 0;  // 0, as described, to max_steps_down
};

/// Command of the host to simulate a body with the cheapest model configuration whose error is within a
/// limit. With the limit 0 nothing changes, but the body's BodyStatus lists the achievable errors from now
/// on.
struct SetAccuracy {
  static constexpr std::string_view name = "set_accuracy";
  BodyId body = 0;
  double percent = 0;  // largest error: 0, or min_accuracy … max_accuracy
};
inline constexpr double min_accuracy = 0.1, max_accuracy = 100;  // %

/// Any command, without its sender. Peers number the kinds of commands in this order, so new ones must be
/// appended.
using CommandBody = std::variant<Join, Grasp, Release, ResetBody, Leave, SetRole, Detach, Attach, Inspect,
                                 EndInspect, OpenPanel, ClosePanel, SetControl, Undo, Rewind, RequestKeyframe,
                                 SetPace, StepTicks, ResetAll, Seek, SetEffort, SetAllEfforts, SetAccuracy>;
inline constexpr std::size_t command_kinds = std::variant_size_v<CommandBody>;

/// Returns the number of the command type `Kind`: its index in CommandBody.
template <class Kind, std::size_t i = 0>
constexpr std::size_t command_number() {
  static_assert(i < command_kinds, "not a command");
  if constexpr (std::is_same_v<Kind, std::variant_alternative_t<i, CommandBody>>)
    return i;
  else
    return command_number<Kind, i + 1>();
}

/// Returns an array with the result of `make.template operator()<Kind>()` for each command type `Kind`, in
/// the order of CommandBody.
template <class Make>
constexpr auto for_each_command(const Make& make) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{make.template operator()<std::variant_alternative_t<i, CommandBody>>()...};
  }
  (std::make_index_sequence<command_kinds>());
}

/// Names of the command types, indexed by command number.
inline constexpr auto command_names = for_each_command([]<class Kind>() { return Kind::name; });

/// Message from a participant to the server: a command. Reliable. Each is answered by one CommandResult with
/// the same participant and sequence number.
struct Command {
  ParticipantId participant = 0;
  std::uint64_t sequence = 0;
  CommandBody body = {};
};

/// Message from the server to a participant: the answer to a command, which was accepted or refused for a
/// reason.
struct CommandResult {
  ParticipantId participant = 0;
  std::uint64_t sequence = 0;
  bool accepted = false;
  std::string reason;  // reason of the refusal; empty if accepted
};

}  // namespace prosector
