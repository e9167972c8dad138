#pragma once
// Cameras: a symmetric one from a pose and a field of view, and a stereo pair with off-axis frusta.

#include "client/view/draw_list.h"
#include "client/view/stereo_profile.h"

namespace prosector {

/// Returns the room pose of an eye at `eye` that looks at `target` (−z ahead), with +y as far up as possible.
/// Looking straight up or down is allowed.
Pose look_at(const Vec3& eye, const Vec3& target);

/// Returns a render camera with a symmetric frustum over a viewport of `width` × `height` pixels. `fov` is
/// the vertical field of view, rad.
DrawCamera mono_camera(const Pose& eye, double fov, int width, int height);

/// Returns the cameras of the left and right eye with parallel axes (never toe-in), for a side-by-side frame
/// of `width` × `height` pixels. With half-width w at the convergence distance D and eye distance e, the left
/// eye's frustum is [(−w + e/2)/D, (w + e/2)/D] in tangents. The right one is mirrored.
std::array<DrawCamera, 2> stereo_cameras(const Pose& head, const StereoProfile& profile, int width,
                                         int height);

}  // namespace prosector
