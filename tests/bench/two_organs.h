#pragma once
// An extreme that no single piece has: two organs of one rung, and a hand that presses them into each other.

#include "tests/bench/stability_run.h"

namespace prosector {

/// Survives: 5 s after the hand has left, each organ has 0.7 to 1.3 of its volume and nothing inside out, and
/// neither is deeper than 2 mm in the other. Degrades: the same, but on the way something was reported.
/// Fails: anything else. Throws InputError when the rung refuses the organs.
StabilityResult press_two_organs(const Rung& rung, double limit_ms);

}  // namespace prosector
