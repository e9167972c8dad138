#pragma once
// What of a hand touches a thing, and whether that can hold it.

#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Where a part of the hand touches something, or is near it.
struct Touch {
  std::size_t part = 0;         // of the hand: the palm, then the segments in joint order
  Vec3 point = Vec3::Zero();    // m, world frame: on the thing
  Vec3 normal = Vec3::UnitY();  // unit, out of the thing
  double gap = 0;               // m
  std::uint32_t vertex = 0;     // of tissue
};

inline constexpr double touching_gap = 0.003;  // m: nearer than that is touched

/// The digits of a hand: five fingers from the thumb, then the palm.
inline constexpr std::size_t digits = 6;
std::size_t digit_of(std::size_t part);
/// Tells whether the touches can hold: the thumb against fingers or palm, or at least two of these around the
/// thing.
bool encloses(std::span<const Touch> touches);
/// Returns those that touch, if they can hold; else all, for hands whose trackers are a little off; none if
/// these can't either.
std::vector<Touch> holding_touches(std::vector<Touch> touches);
/// Returns the nearest touch of each digit.
std::vector<Touch> nearest_of_each_digit(std::span<const Touch> touches);

}  // namespace prosector
