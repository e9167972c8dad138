#pragma once
// The open hand as an implicit solid around the bones of common/hand.h.

#include <array>

#include "common/hand.h"

namespace prosector {

/// Approximate signed distances (m) of the right hand's surfaces from one point of its wrist frame, negative
/// inside.
struct HandField {
  double solid = 0;                    // of the whole hand
  std::array<double, fingers> finger;  // of each finger's flesh alone, thumb first
};

HandField hand_field(const Vec3& at);

}  // namespace prosector
