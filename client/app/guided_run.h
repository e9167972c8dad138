#pragma once
// A guide shown in the terminal: what to do, how far it is, what is wrong.

#include <functional>

#include "drivers/fitting/guide.h"

namespace prosector {

/// Lets a device's samples go through the guide until it is done, and prints what a person must know. `also`
/// is called each time. Throws InputError where that takes longer than `patience` seconds.
void run_guide(Guide& guide, Device& device, double patience, const std::function<void()>& also = {});

}  // namespace prosector
