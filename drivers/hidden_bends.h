#pragma once
// What bends that a camera sees count for when it comes to gestures.
//
// Closed fingers hide each other and their own tips: networks then see fists half open, by more or less from
// each side. Thumbs close by less than fingers.

#include <array>

#include "common/messages.h"

namespace prosector {

/// Returns the bends by which a glove's thresholds tell a gesture of what a camera saw: 0 and 1 as they are.
/// Each grows with its own, but where all four fingers are seen half bent, and alike: that is a fist.
std::array<double, fingers> bends_for_gestures(const std::array<double, fingers>& seen);

}  // namespace prosector
