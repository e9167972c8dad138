#pragma once
// Messages about hands: poses that participants send, poses and contacts that the server returns, and what a
// haptic arm exchanges. Metres, newtons, joules; poses are in the room.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/contact_plane.h"
#include "common/hand_pose.h"
#include "common/ids.h"
#include "common/math.h"

namespace prosector {

inline constexpr std::size_t max_holders = 64;  // hands listed as holding one body

/// Message from a participant to the server: tracked poses of head, hands and held objects. Best effort, 120
/// Hz. An observer's input has no effect.
struct HandInput {
  ParticipantId participant = 0;
  std::uint64_t sequence =
      0;  // increases by one per sample; the journal keys inputs by (tick, participant, sequence)
  std::int64_t time_ns = 0;  // sender's monotonic clock at the start of the device's record; informative
  bool head_tracked = false;
  Pose head;  // eyes in the room frame: −z is the viewing direction
  std::array<HandPose, 2> hands{};
  std::array<HeldPose, held_things> held{};  // in the order of HeldObject
};

/// Message from the server to all clients: the head pose and the simulated hand poses of one participant.
/// Best effort.
struct UserState {
  ParticipantId participant = 0;
  SimTime time;
  std::uint64_t input_sequence = 0;  // sequence number of the last HandInput consumed
  bool head_tracked = false;
  Pose head;
  std::array<HandPose, 2>
      hands{};  // pose of the physical hand, which contacts may keep from its tracked target
};

/// Message from the server to all clients: the strongest contact of a hand, or the one that it is about to
/// make first. Best effort, keyed by (participant, hand).
struct ContactSample {
  ParticipantId participant = 0;
  std::uint8_t hand = right_hand;
  SimTime time;
  bool touching = false;
  BodyId body = 0;
  Vec3 point = Vec3::Zero();        // world frame
  Vec3 normal = {0, 1, 0};          // out of the touched body
  double depth = 0;                 // metres, > 0: penetration, < 0: gap
  double impulse = 0;               // N·s over the last tick, summed over all contacts of this hand
  Vec3 local_point = Vec3::Zero();  // `point` in the touched body's frame; soft: its rest position
  Vec3 force = Vec3::Zero();        // N, mean over the last tick: force of the hand on the body
  double impact = -1;  // s from the tick's start until contact; 0: already in contact; < 0: no contact
};

/// Message from the server to participants with a haptic arm: contact planes (local models of the contact
/// force) of a hand, each tick. Best effort, keyed by (participant, hand). An empty list means no force. It
/// is sent too, so that a gap in the messages means a lost connection.
struct FeltPlanes {
  ParticipantId participant = 0;
  std::uint8_t hand = right_hand;
  SimTime time;
  std::uint64_t input_sequence = 0;  // sequence number of the last HandInput that the tick consumed
  std::vector<ContactPlane> planes;  // at most max_contact_planes
  double taken = 0;                  // J, since the hand appeared: energy that the hand gave to bodies …
  double given = 0;                  // … and energy that bodies gave to the hand; neither decreases
};

/// Message from a participant to the server: force and energy of the haptic arm that drives a hand, sent with
/// each HandInput. Best effort, keyed by (participant, hand).
struct ArmForce {
  ParticipantId participant = 0;
  std::uint8_t hand = right_hand;
  std::uint64_t sequence = 0;   // increases by one per sample
  Vec3 force = Vec3::Zero();    // N, on the hand, mean since the previous sample
  double taken = 0, given = 0;  // J, as in FeltPlanes: from and to the user's hand
};
inline constexpr double max_arm_force = 1000;  // N
inline constexpr double max_arm_energy = 1e9;  // J

}  // namespace prosector
