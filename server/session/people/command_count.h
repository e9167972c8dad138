#pragma once
// Counts the commands of each kind that a session granted and refused.

#include <array>
#include <cstdint>

#include "common/commands.h"

namespace prosector {

struct CommandCount {
  std::uint64_t granted = 0, refused = 0;
};
using CommandCounts = std::array<CommandCount, command_kinds>;  // by number

}  // namespace prosector
