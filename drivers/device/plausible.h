#pragma once
// Plausibility bounds for all numbers that devices send. Each driver checks them before any computation.
// Otherwise a quaternion that is too long or not finite could be normalised to no rotation. Implausible
// values are dropped and counted.

#include <optional>
#include <vector>

#include "drivers/device/device.h"

namespace prosector {

inline constexpr double tracker_reach = 100;    // m: beyond the range of any tracker or camera
inline constexpr double arm_reach = 2;          // m: beyond the reach of any haptic arm
inline constexpr double unit_tolerance = 0.05;  // tolerance of unit lengths, since some senders round

/// Returns whether a position is finite and at most `reach` metres from the device.
bool is_within(const Vec3& position, double reach);
/// Returns whether a quaternion or direction is finite and has length 1 within the tolerance.
bool is_unit(const Quat& q, double tolerance = unit_tolerance);
bool is_unit(const Vec3& direction, double tolerance = unit_tolerance);
/// Returns whether a matrix is a rotation up to rounding errors.
bool is_rotation(const Mat3& matrix);

/// Returns a pose with a unit quaternion. Returns nothing if the position is not finite or farther than
/// `reach` metres, or the quaternion or matrix is not a rotation.
std::optional<Pose> plausible_pose(const Vec3& position, const Quat& rotation, double reach);
std::optional<Pose> plausible_pose(const Vec3& position, const Mat3& rotation, double reach);

/// Returns whether a sample may leave its driver: finite position in the room, unit quaternion, finite raw
/// numbers, flexions from 0 to 1.
bool is_plausible(const DeviceSample& sample);
/// Removes implausible samples from index `first` on. Returns the number removed.
std::size_t remove_implausible(std::vector<DeviceSample>& samples, std::size_t first);

/// Limits a force or torque to length `most` without changing its direction. Returns zero if it is not
/// finite.
Vec3 bounded_force(const Vec3& force, double most);

}  // namespace prosector
