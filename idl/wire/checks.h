#pragma once
// The questions that the edge asks of every sample.

#include <cmath>
#include <string_view>

#include "common/messages.h"
#include "common/refusal.h"
#include "common/valid_text.h"

namespace prosector {

inline constexpr double max_speed = 1000.0;         // m/s
inline constexpr double max_angular_speed = 1.0e4;  // rad/s
inline constexpr double flexion_slack = 0.05;       // a glove may report a little outside [0, 1]
inline constexpr double quaternion_slack = 0.01;    // | |q| − 1 | that is re-normalised rather than refused

/// Keeps the first reason of a row of checks.
class Checks {
 public:
  Checks& that(bool ok, const char* otherwise) {
    if (!ok && first_ == nullptr) first_ = otherwise;
    return *this;
  }
  Refusal refusal() const { return first_ == nullptr ? Refusal() : Refusal(first_); }

 private:
  const char* first_ = nullptr;  // a literal
};

/// Tells whether it is finite and at most `limit` in each component's magnitude.
bool within(const Vec3& v, double limit);
inline bool within(double x, double low, double high) {
  return std::isfinite(x) && x >= low && x <= high;
}
template <class E>
bool enum_within(E value, E last) {
  return static_cast<std::uint8_t>(value) <= static_cast<std::uint8_t>(last);
}

/// Checks a position in the room and a quaternion that is unit within quaternion_slack, which is then
/// re-normalised.
Refusal check_pose(Pose& pose);
Refusal check_color(const Vec3& color);
/// Checks that a shape is finite, in the room, entries at most most_shape, and not collapsed: a determinant
/// away from 0.
Refusal check_shape(const Affine& shape);

}  // namespace prosector
