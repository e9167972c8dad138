#pragma once
// Runs a calibration guide in the terminal: prints instructions, progress and problems.

#include <functional>

#include "drivers/fitting/guide.h"

namespace prosector {

/// Passes a device's samples to a calibration guide until it is done, and prints its instructions and
/// progress in the terminal. `also` is called after each poll of the device. Throws InputError after
/// `time_limit` seconds.
void run_guide(Guide& guide, Device& device, double time_limit, const std::function<void()>& also = {});

}  // namespace prosector
