#pragma once
// Cameras: from a pose and a field of view, and a pair of eyes with off-axis frusta.

#include "client/view/draw_list.h"
#include "client/view/stereo_profile.h"

namespace prosector {

/// Returns the pose of an eye at `eye` that looks at `target` with +y up as far as possible; straight up or
/// down is fine.
Pose look_at(const Vec3& eye, const Vec3& target);

/// Returns a symmetric frustum over the whole picture; `fov` is vertical, in radians.
DrawCamera mono_camera(const Pose& eye, double fov, int width, int height);

/// Returns left and right eye, parallel axes (never toe-in). With half-width w at distance D and eye distance
/// e, the left eye's frustum is [(−w + e/2)/D, (w + e/2)/D] in tangents, the right one's mirrored.
std::array<DrawCamera, 2> stereo_cameras(const Pose& head, const StereoProfile& profile, int width,
                                         int height);

}  // namespace prosector
