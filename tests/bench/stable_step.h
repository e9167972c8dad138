#pragma once
// How large a step a rung bears.

#include <functional>
#include <memory>

#include "server/calibration/specimen.h"

namespace prosector {

inline constexpr double largest_step_tried = 1;  // s

/// `make`: a specimen of the rung. s, to a factor of √2: the largest step up to which a swinging, undamped
/// beam of 192 tetrahedra stays finite, goes no further than twice its start and gains no more than 1 % of
/// energy (where the specimen tells it) in 40 steps. largest_step_tried: no limit was found. 0: refused, or
/// unstable at the smallest step tried, 2e-5 s.
double largest_stable_step(const std::function<std::unique_ptr<Specimen>(const TestPiece&)>& make);

}  // namespace prosector
