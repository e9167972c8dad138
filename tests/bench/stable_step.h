#pragma once
// How large a step a rung bears.

#include "tests/bench/rung.h"

namespace prosector {

inline constexpr double largest_step_tried = 1;  // s

/// s, to a factor of √2: the largest step up to which a swinging, undamped beam of 192 tetrahedra stays
/// finite and gains no more than 1 % of energy in 40 steps. largest_step_tried: no limit was found. 0:
/// refused, or unstable at the smallest step tried, 2e-5 s.
double largest_stable_step(const Rung& rung);

}  // namespace prosector
