#pragma once
// Messages about a session and its participants: description, presence and roster.

#include <cstddef>
#include <cstdint>
#include <string>

#include "common/hash.h"
#include "common/ids.h"
#include "common/math.h"

namespace prosector {

inline constexpr std::size_t max_language_length = 35;  // bytes: a language tag (RFC 5646, 4.4.1)

/// Message from the server to all clients: the description of the session. It is the first message that a
/// client reads, and suffices to refuse an incompatible session with a clear error.
struct SessionInfo {
  std::uint32_t version = protocol_version;
  std::string session;           // also the DDS partition
  std::string scene;             // the scene's name
  ContentHash scene_hash{};      // of the compiled scene: geometry, materials, settings
  double tick_rate = 60;         // Hz
  std::uint32_t capacity = 0;    // maximum number of participants, observers included
  std::uint64_t server_run = 0;  // differs from run to run: a client that sees it change starts over
};

/// Message from a client to the server: the participant's identity, requested role and devices. Written once,
/// with a liveliness lease of 1 s. The participant leaves when its client disposes of the sample or loses
/// liveliness.
struct Presence {
  ParticipantId participant = 0;
  std::uint32_t version = protocol_version;
  std::string name;
  Role role = Role::observer;  // requested role; the server's RosterEntry holds the assigned one
  std::string devices;         // text for users: "fastrak, 5dt-serial"
  std::uint8_t arms = 0;       // hands driven by a haptic arm: bit 0 left, bit 1 right
};

/// Message from the server to all clients: a participant of the session with its assigned role and colour.
/// There is one per participant, which is disposed of when the participant leaves.
struct RosterEntry {
  ParticipantId participant = 0;
  std::string name;
  Role role = Role::observer;
  Vec3 color = Vec3::Ones();
  std::string devices;
};

}  // namespace prosector
