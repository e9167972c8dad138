#pragma once
// Runs a calibration guide in the terminal: prints instructions, progress and problems.

#include <functional>

#include "drivers/fitting/guide.h"

namespace prosector {

/// Feeds a device's samples to the guide until it is done, and prints its instructions. `also` is called
/// after each poll. Throws InputError after `patience` seconds.
void run_guide(Guide& guide, Device& device, double time_limit, const std::function<void()>& also = {});

}  // namespace prosector
