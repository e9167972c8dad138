#pragma once
// Bounds of every number that a device sends. Each driver checks with these before it computes anything: a
// quaternion that is too long or no number would else be normalised to no rotation at all. What fails is
// dropped and counted.

#include <optional>
#include <vector>

#include "drivers/device.h"

namespace prosector {

inline constexpr double tracker_reach = 100;    // m: farther than any tracker or camera sees
inline constexpr double arm_reach = 2;          // m: farther than any haptic arm reaches
inline constexpr double unit_tolerance = 0.05;  // of a length that should be 1: some senders round

/// Returns whether a position is finite and at most `reach` metres from the device.
bool is_within(const Vec3& position, double reach);
/// Returns whether a quaternion or direction is finite and has length 1 within the tolerance.
bool is_unit(const Quat& q, double tolerance = unit_tolerance);
bool is_unit(const Vec3& direction, double tolerance = unit_tolerance);
/// Returns whether a matrix is a rotation, except for rounding.
bool is_rotation(const Mat3& matrix);

/// Returns a pose with a unit quaternion. Returns nothing for a position that is not finite or farther than
/// `reach` metres, and for a quaternion or matrix that is no rotation.
std::optional<Pose> plausible_pose(const Vec3& position, const Quat& rotation, double reach);
std::optional<Pose> plausible_pose(const Vec3& position, const Mat3& rotation, double reach);

/// Returns whether a sample may leave its driver: a finite pose in the room with a unit quaternion, finite
/// raw numbers, bends from 0 to 1.
bool is_plausible(const DeviceSample& sample);
/// Removes implausible samples from index `first` on. Returns how many they were.
std::size_t drop_implausible(std::vector<DeviceSample>& samples, std::size_t first);

/// Returns a force or torque that an arm may have: one that is not finite is none, a longer one than `most`
/// keeps its direction.
Vec3 bounded_force(const Vec3& force, double most);

}  // namespace prosector
