#pragma once
// State of a member of the session: its newest inputs, its hands, and its commands that wait for the step.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "idl/bus.h"
#include "server/physics/simulation.h"
#include "server/session/people/sequence_gate.h"

namespace prosector {

/// Why a hand vanished: its client did not track it, or sent nothing.
enum class HandLoss : std::uint8_t { none, untracked, stalled };

/// A hand of a member.
struct MemberHand {
  bool present = false;
  std::uint64_t tracked_tick = 0;
  HandTarget target;
  HandLoss loss = HandLoss::none;       // why the hand vanished in this tick
  std::optional<BodyId> regrasps = {};  // body that it grasps again in this tick, after a stall
};

/// Force of a haptic arm on a hand.
struct ArmReaction {
  SequenceGate sequences = {};
  std::uint64_t tick = 0;  // tick of the newest sample
  double force = 0;        // N
};

/// A command to grasp that is answered after the tick's physics step.
struct PendingGrasp {
  Command command;
  std::uint8_t hand = right_hand;
};

/// A command for an anatomical part that is answered after the tick's physics step.
struct PendingPart {
  Command command;
  PartEvent event;
};

/// A command to undo a cut or rewind the session that is answered after the tick's physics step.
struct PendingCut {
  Command command;
  CutEvent event;
  std::string rewinds_to;  // for the log; empty: an undo
};

struct Seat {
  std::optional<HandInput> input;
  SequenceGate sequences;
  bool fresh = false;
  std::uint64_t heard_tick = 0;  // tick of the newest input
  std::array<MemberHand, 2> hands;
  std::vector<HandEvent> asked;          // requested by its commands since the last tick
  std::array<bool, 2> opens{};           // hands that a command opened in this tick
  std::vector<PendingGrasp> grasps;      // waiting for the step
  std::vector<PendingPart> parts;        // waiting for the step
  std::vector<PendingCut> cuts;          // waiting for the step
  std::uint32_t commands = 0;            // in this tick
  std::array<ArmReaction, 2> reactions;  // forces of haptic arms, by hand
};

}  // namespace prosector
