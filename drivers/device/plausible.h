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

/// Returns whether all coordinates of a position are finite and its distance from the origin is at most
/// `reach` metres.
bool is_within(const Vec3& position, double reach);
/// Returns whether the length of a quaternion or direction is finite and differs from 1 by less than
/// `tolerance`.
bool is_unit(const Quat& q, double tolerance = unit_tolerance);
bool is_unit(const Vec3& direction, double tolerance = unit_tolerance);
/// Returns whether a matrix is a rotation (orthonormal, determinant 1). Inner products of its columns may
/// deviate by rounding errors of about 0.001.
bool is_rotation(const Mat3& matrix);

/// Returns the pose with its quaternion normalised. Returns nothing if the position is not finite or farther
/// than `reach` metres from the origin, or if `rotation` is not a rotation within the tolerance.
std::optional<Pose> plausible_pose(const Vec3& position, const Quat& rotation, double reach);
std::optional<Pose> plausible_pose(const Vec3& position, const Mat3& rotation, double reach);

/// Returns whether a device sample has only plausible numbers, so that its driver may pass it on. A pose
/// needs a finite position in the room, a unit quaternion and finite raw numbers; flexions must be from 0 to
/// 1.
bool is_plausible(const DeviceSample& sample);
/// Removes samples with implausible numbers (such as a non-finite position) among those from index `first`
/// on. Returns the number of removed samples.
std::size_t remove_implausible(std::vector<DeviceSample>& samples, std::size_t first);

/// Shortens a force or torque to length `most` if it is longer, without changing its direction. Returns zero
/// if the vector is not finite.
Vec3 bounded_force(const Vec3& force, double most);

}  // namespace prosector
