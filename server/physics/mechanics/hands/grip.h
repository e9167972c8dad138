#pragma once
// Contact points of a hand on a body, and whether they can hold the body.

#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector::hands {

/// Point of a body that a part of the hand (the palm or a finger segment) touches or is close to.
struct Touch {
  std::size_t part = 0;         // index of the hand's part: the palm, then the segments in joint order
  Vec3 point = Vec3::Zero();    // m, world frame: on the body
  Vec3 normal = Vec3::UnitY();  // unit, out of the body
  double gap = 0;               // m
  std::uint32_t vertex = 0;     // tissue: surface vertex
};

inline constexpr double touching_gap = 0.003;  // m: smaller gaps count as touching

/// Number of digits of a hand, in the order of their indices: the five fingers from the thumb, then the palm,
/// which counts as a digit.
inline constexpr std::size_t digits = 6;
std::size_t digit_of(std::size_t part);
/// Returns whether the touches can hold a body: they must be by at least two different digits (fingers or
/// palm).
bool encloses(std::span<const Touch> touches);
/// Returns the touches by which a hand can hold a body. These are the touches with a gap up to
/// `touching_gap`, if they are by at least two digits. Otherwise it returns all touches, since the hand
/// tracker may be slightly off. It returns none if all touches are by one digit.
std::vector<Touch> holding_touches(std::vector<Touch> touches);
/// Returns for each digit (five fingers and palm) that has touches the one with the smallest gap, in the
/// order of the digits.
std::vector<Touch> nearest_of_each_digit(std::span<const Touch> touches);

}  // namespace prosector::hands
