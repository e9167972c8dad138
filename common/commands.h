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

/// Asks to be admitted to the session.
struct Join {
  static constexpr std::string_view name = "join";
};

/// Grasps with a hand: the nearest rigid body that it can hold, else the nearest tissue.
struct Grasp {
  static constexpr std::string_view name = "grasp";
  std::uint8_t hand = right_hand;
  std::optional<BodyId> body = {};  // grasped rather than the nearest one, if it is within reach
};

/// Releases what a hand holds.
struct Release {
  static constexpr std::string_view name = "release";
  std::uint8_t hand = right_hand;
};

/// Puts a body back to rest, in its place, as the scene has it.
struct ResetBody {
  static constexpr std::string_view name = "reset";
  BodyId body = 0;
  std::uint8_t hand = right_hand;  // whose gesture requested it; journalled only
};

/// Leaves the session.
struct Leave {
  static constexpr std::string_view name = "leave";
};

/// Assigns a role, by the host. A host that passes on its role becomes a dissector.
struct SetRole {
  static constexpr std::string_view name = "set_role";
  ParticipantId subject = 0;  // participant that gets the role
  Role role = Role::observer;
};

/// Takes a part out of the anatomy.
struct Detach {
  static constexpr std::string_view name = "detach";
  BodyId body = 0;
};

/// Puts a part back into the anatomy, if it is near enough to its place.
struct Attach {
  static constexpr std::string_view name = "attach";
  BodyId body = 0;
};

/// Shows a body moved, rotated, scaled or sheared, where nothing touches it.
struct Inspect {
  static constexpr std::string_view name = "inspect";
  BodyId body = 0;
  Affine shape = {};  // from the position of a point of the body to where it is displayed, m, world frame
};

/// Ends the inspection of a body.
struct EndInspect {
  static constexpr std::string_view name = "end_inspect";
  BodyId body = 0;
};

/// Opens the panel of a part, as a touch does, or moves the sender's open panel.
struct OpenPanel {
  static constexpr std::string_view name = "open_panel";
  BodyId body = 0;
  PanelPlacement placing = PanelPlacement::stays;
  Vec3 at = Vec3::Zero();  // m, world frame: the panel's new centre, for PanelPlacement::put
};

/// Closes the sender's panel.
struct ClosePanel {
  static constexpr std::string_view name = "close_panel";
};

/// Sets a control of the sender's open panel, as a finger does.
struct SetControl {
  static constexpr std::string_view name = "set_control";
  PanelControl control = PanelControl::attach;
  double value = 0;  // button: 0 off, 1 on; slider: 0 … 1
};

/// Takes back the sender's last cut.
struct Undo {
  static constexpr std::string_view name = "undo";
};

/// Restores the scene when a body got a revision of its topology, by the host.
struct Rewind {
  static constexpr std::string_view name = "rewind";
  BodyId body = 0;
  std::uint32_t revision = 0;  // of the body
};

/// Requests the complete topology of a body, because the sender's copy doesn't fit its log.
struct RequestKeyframe {
  static constexpr std::string_view name = "keyframe";
  BodyId body = 0;
};

/// Sets the pace of simulated time, by the host.
struct SetPace {
  static constexpr std::string_view name = "set_pace";
  double pace = 0;  // simulated seconds per real second: 0 stops time, else min_pace … 1, or … max_pace
};
inline constexpr double min_pace = 1.0 / 64, max_pace = 8;  // above 1: in recordings only

/// Stops time after some more ticks, by the host.
struct StepTicks {
  static constexpr std::string_view name = "step_ticks";
  std::uint32_t ticks = 0;  // 1 … most_steps
};
inline constexpr std::uint32_t most_steps = 6000;

/// Restores the state that the server began with, by the host.
struct ResetAll {
  static constexpr std::string_view name = "reset_all";
};

/// Continues a recording at another time.
struct Seek {
  static constexpr std::string_view name = "seek";
  std::uint32_t tick = 0;  // whose end is shown
};

inline constexpr std::uint32_t max_steps_down = 3;

/// Sets how exactly a body is solved from now on, by the host.
struct SetEffort {
  static constexpr std::string_view name = "set_effort";
  BodyId body = 0;
  std::uint32_t steps_down = 0;  // 0, as described, to max_steps_down
};

/// Sets how exactly all deformable bodies are solved from now on, by the host.
struct SetAllEfforts {
  static constexpr std::string_view name = "set_all_efforts";
  std::uint32_t steps_down = 0;  // 0, as described, to max_steps_down
};

/// Requests the cheapest model configuration of a body within an error, by the host. With 0 nothing changes,
/// but its BodyStatus lists the achievable errors from now on.
struct SetAccuracy {
  static constexpr std::string_view name = "set_accuracy";
  BodyId body = 0;
  double percent = 0;  // largest error: 0, or min_accuracy … max_accuracy
};
inline constexpr double min_accuracy = 0.1, max_accuracy = 100;  // %

/// Peers number the commands in this order: append new ones.
using CommandBody = std::variant<Join, Grasp, Release, ResetBody, Leave, SetRole, Detach, Attach, Inspect,
                                 EndInspect, OpenPanel, ClosePanel, SetControl, Undo, Rewind, RequestKeyframe,
                                 SetPace, StepTicks, ResetAll, Seek, SetEffort, SetAllEfforts, SetAccuracy>;
inline constexpr std::size_t command_kinds = std::variant_size_v<CommandBody>;

/// Returns the number of a kind of command.
template <class Kind, std::size_t i = 0>
constexpr std::size_t command_number() {
  static_assert(i < command_kinds, "not a command");
  if constexpr (std::is_same_v<Kind, std::variant_alternative_t<i, CommandBody>>)
    return i;
  else
    return command_number<Kind, i + 1>();
}

/// Returns `make.template operator()<Kind>()` of each kind of command, in their order.
template <class Make>
constexpr auto for_each_command(const Make& make) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{make.template operator()<std::variant_alternative_t<i, CommandBody>>()...};
  }
  (std::make_index_sequence<command_kinds>());
}

/// The commands' names, by number.
inline constexpr auto command_names = for_each_command([]<class Kind>() { return Kind::name; });

/// participant → server, reliable; each is answered by one CommandResult with the same participant and
/// sequence.
struct Command {
  ParticipantId participant = 0;
  std::uint64_t sequence = 0;
  CommandBody body = {};
};

/// server → participant: the answer to a command.
struct CommandResult {
  ParticipantId participant = 0;
  std::uint64_t sequence = 0;
  bool accepted = false;
  std::string reason;  // reason of the refusal; empty if accepted
};

}  // namespace prosector
