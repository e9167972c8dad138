#pragma once
// Counts the commands of each kind that a session granted and refused.

#include <array>
#include <cstdint>
#include <string_view>

#include "common/messages.h"

namespace prosector {

/// The commands' names, in the order of CommandKind.
inline constexpr std::array<std::string_view, 23> command_names = {
    "join",        "grasp",  "release",    "reset",           "leave",       "set_role",
    "detach",      "attach", "inspect",    "end_inspect",     "open_panel",  "close_panel",
    "set_control", "undo",   "rewind",     "keyframe",        "set_pace",    "step_ticks",
    "reset_all",   "seek",   "set_effort", "set_all_efforts", "set_accuracy"};
static_assert(command_names.size() == static_cast<std::size_t>(last_command) + 1);

struct CommandCount {
  std::uint64_t granted = 0, refused = 0;
};
using CommandCounts = std::array<CommandCount, command_names.size()>;

}  // namespace prosector
