#pragma once
// Points in an order that keeps neighbours together.

#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Their indices along a Morton curve through their box, 1024 cells along its longest side; of the points in
/// one cell the first comes first. In linear time.
std::vector<std::uint32_t> space_order(std::span<const Vec3> points);

}  // namespace prosector
