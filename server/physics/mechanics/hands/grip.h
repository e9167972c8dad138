#pragma once
// Contact points of a hand on a body, and whether they can hold the body.

#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// A point of a body that a part of the hand touches or is near to.
struct Touch {
  std::size_t part = 0;         // index of the hand's part: the palm, then the segments in joint order
  Vec3 point = Vec3::Zero();    // m, world frame: on the body
  Vec3 normal = Vec3::UnitY();  // unit, out of the body
  double gap = 0;               // m
  std::uint32_t vertex = 0;     // tissue: surface vertex
};

inline constexpr double touching_gap = 0.003;  // m: smaller gaps count as touching

/// Number of digits of a hand: five fingers from the thumb, then the palm.
inline constexpr std::size_t digits = 6;
std::size_t digit_of(std::size_t part);
/// Returns whether the touches can hold a body: the thumb against fingers or palm, or at least two digits
/// around it.
bool encloses(std::span<const Touch> touches);
/// Returns the touches with a gap up to touching_gap if they can hold the body. Otherwise returns all, since
/// trackers may be slightly off, or none if all together can't hold it either.
std::vector<Touch> holding_touches(std::vector<Touch> touches);
/// Returns the nearest touch of each digit.
std::vector<Touch> nearest_of_each_digit(std::span<const Touch> touches);

}  // namespace prosector
