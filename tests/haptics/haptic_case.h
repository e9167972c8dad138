#pragma once
// A hand presses tissue over a network with an arm, all in virtual time: the client's own servo loop, an
// arm's mechanics held by a modelled hand, a line with delay, jitter and loss, and tissue that answers 60
// times a second.

#include <cstdint>

#include "client/haptics/haptic_loop.h"
#include "drivers/arms/omni.h"
#include "twins/arms/arm_model.h"

namespace prosector {

struct LineQuality {
  double round_trip = 0;  // s
  double jitter = 0;      // s: each way takes up to that much longer, evenly distributed
  double loss = 0;        // share of messages
};

/// What is told of the tissue, and how.
struct HapticScheme {
  const char* name;
  const char* help;
  double reported_stiffness;  // N/m, of planes; below 0: times the tissue's own, negated
  bool before_contact;        // planes are told of before they are reached
  Safeguards safeguards;
};

struct HapticCase {
  double stiffness = 300;     // N/m, of the tissue
  double tissue_damping = 0;  // N·s/m
  LineQuality line;
  HandImpedance hand = light_hand;
  double frequency = 0;  // Hz: the hand swings about its depth after it has arrived; 0: it stays
  double depth = 0.01;   // m: how far in the hand wants to be
  bool free = false;     // nothing is touched: the hand swings in air
  double seconds = 3;
  std::uint64_t seed = 1;
};

struct HapticResult {
  double ripple = 0;         // m: largest less smallest place in the last second
  double felt = 0;           // static: mean force over mean depth there, over the tissue's stiffness
  double felt_swinging = 0;  // the same of what swings with the hand's frequency
  double least_energy = 0;   // J: least that the motors had taken from the hand, at any time
  double onset = 0;          // s: from reaching the tissue to feeling 0.05 N
  double peak = 0;           // largest force over that at rest
  double drag = 0;           // N: mean force against the motion
  bool finite = true;
};

HapticResult run(const HapticScheme& scheme, const HapticCase& test);

inline constexpr double dt = 1e-3;  // s: the servo's period

}  // namespace prosector
