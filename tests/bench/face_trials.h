#pragma once
// Face detection with a synthetic face before a camera at a screen: error of the direction from the eyes to
// the screen's centre, by distance, rotation, motion, light and resolution.

#include <functional>

#include "tests/bench/report.h"

namespace prosector {

/// Measures and passes each row to `take`. Prints a message and measures nothing if the network is missing.
/// `quick`: few images.
void measure_faces(bool quick, const std::function<void(const ReportRow&)>& take);

}  // namespace prosector
