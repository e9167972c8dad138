#pragma once
// Largest stable time step of a configuration.

#include <functional>
#include <memory>

#include "server/calibration/specimen.h"

namespace prosector {

inline constexpr double largest_step_tried = 1;  // s

/// Returns the largest stable time step, s, to a factor of √2. A step is stable if an undamped, oscillating
/// beam of 192 tetrahedra stays finite, within twice its initial amplitude, and gains at most 1 % of energy
/// (if the specimen reports it) in 40 steps. Returns largest_step_tried if no limit was found; 0 if the
/// configuration is refused or unstable at the smallest step, 2e-5 s. `make` creates a specimen of it.
double largest_stable_step(const std::function<std::unique_ptr<Specimen>(const TestPiece&)>& make);

}  // namespace prosector
