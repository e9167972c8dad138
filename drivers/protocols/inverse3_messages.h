#pragma once
// Messages of Haply's Inverse Service, JSON texts on a WebSocket: a client answers each state with a force.
// Positions in m, forces in N; x right, y forward, z up.

#include <optional>
#include <string>
#include <string_view>

#include "common/math.h"

namespace prosector::inverse3 {

/// State that Haply's service reports: the cursor's position (m) of its first Inverse3 arm, and the rotation
/// and buttons of its first grip.
struct State {
  std::string device;            // device id; empty: no arm
  Vec3 place = Vec3::Zero();     // of the cursor
  Quat turn = Quat::Identity();  // of the grip; identity without a grip
  std::uint32_t buttons = 0;     // bits 0, 1, 2: buttons a, b, c
};

/// Parses a state message (JSON) of Haply's service. Returns nothing if the text is invalid or incomplete.
/// Never throws.
std::optional<State> state_of(std::string_view text);
/// Formats a state as a JSON message of Haply's service, for the simulated service. `first` adds the extra
/// fields of a connection's first state.
std::string text_of(const State& state, bool first);

struct Force {
  std::string device;  // device id; empty: the message sets no force
  Vec3 force = Vec3::Zero();
};
/// Parses a client's force command (JSON) to Haply's service, for the simulated service. Returns nothing if
/// the text sets no force. Never throws.
std::optional<Force> force_of(std::string_view text);
std::string text_of(const Force& force);

/// Returns the rotation from the axes of Haply's service (x right, y forward, z up) to the arm frame (x
/// right, y up, z towards the user).
Mat3 axes();

}  // namespace prosector::inverse3
