#pragma once
// Checks applied to every sample on the wire.

#include <cmath>
#include <string_view>

#include "common/math.h"
#include "common/refusal.h"
#include "common/valid_text.h"

namespace prosector {

inline constexpr double max_speed = 1000.0;         // m/s
inline constexpr double max_angular_speed = 1.0e4;  // rad/s
inline constexpr double flexion_slack = 0.05;       // a glove may report slightly outside [0, 1]
inline constexpr double quaternion_slack = 0.01;  // largest | |q| − 1 | that is re-normalised, not refused

/// Sequence of checks of one sample. It stores the reason of the first check that failed.
class Checks {
 public:
  Checks& that(bool ok, const char* otherwise) {
    if (!ok && first_ == nullptr) first_ = otherwise;
    return *this;
  }
  Refusal refusal() const { return first_ == nullptr ? Refusal() : Refusal(first_); }

 private:
  const char* first_ = nullptr;  // string literal
};

/// Returns whether the vector is finite and each component's magnitude is at most `limit`.
bool within(const Vec3& v, double limit);
inline bool within(double x, double low, double high) {
  return std::isfinite(x) && x >= low && x <= high;
}
template <class E>
bool enum_within(E value, E last) {
  return static_cast<std::uint8_t>(value) <= static_cast<std::uint8_t>(last);
}

/// Checks that the pose's position is within the allowed coordinates and that its quaternion has unit length
/// within quaternion_slack. Re-normalises the quaternion. Returns the reason if a check fails.
Refusal check_pose(Pose& pose);
Refusal check_color(const Vec3& color);
/// Checks that the transform of an inspected body is finite, within the allowed coordinates, and not
/// collapsed (determinant not near 0). Its matrix entries must be at most max_shape_entry. Returns the reason
/// if a check fails.
Refusal check_shape(const Affine& shape);

}  // namespace prosector
