#pragma once
// The messages of Haply's Inverse Service, JSON texts on a WebSocket: each state is answered by a force.
// Places are m, forces N; x right, y forward, z up.

#include <optional>
#include <string>
#include <string_view>

#include "common/math.h"

namespace prosector::inverse3 {

/// What the service says of its first Inverse3, and the first grip.
struct State {
  std::string device;            // its id; empty: there is none
  Vec3 place = Vec3::Zero();     // of the cursor
  Quat turn = Quat::Identity();  // of the grip; without one it isn't turned
  std::uint32_t buttons = 0;     // bits 0, 1, 2: a, b, c
};

/// Returns nothing where the text is no state, or lacks something of one. Never throws.
std::optional<State> state_of(std::string_view text);
/// Returns the text of a state. `first`: the first one of a connection, with what else is in that.
std::string text_of(const State& state, bool first);

struct Force {
  std::string device;  // empty: none is told anything
  Vec3 force = Vec3::Zero();
};
/// Returns nothing where the text sets no force. Never throws.
std::optional<Force> force_of(std::string_view text);
std::string text_of(const Force& force);

/// Turns vectors of the service's axes into those of an arm's frame (x right, y up, z towards the user).
Mat3 axes();

}  // namespace prosector::inverse3
