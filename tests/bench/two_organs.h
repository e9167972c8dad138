#pragma once
// Stability test with two organs of one configuration and a hand that presses them into each other.

#include "tests/bench/stability_run.h"

namespace prosector {

/// Runs the test and returns its verdict. Survives: 5 s after the hand has left, each organ has 0.7 to 1.3 of
/// its volume, no element is inverted, and the penetration depth is at most 2 mm. Degrades: the same, but a
/// step reported a loss. Fails: anything else. `limit_ms`: limit of CPU time. Throws InputError if the
/// configuration refuses the organs.
StabilityResult press_two_organs(const Rung& rung, double limit_ms);

}  // namespace prosector
