#pragma once
// Initial view of a desk user: the anatomy fills the frame, and the seat differs from those of others.

#include <array>
#include <optional>
#include <vector>

#include "client/app/desk/orbit_view.h"
#include "common/appearance.h"
#include "common/math.h"

namespace prosector {

inline constexpr std::size_t saved_views = 9;  // on the number keys, from 1

struct DeskStart {
  ViewPlace home;
  double fov = 0.8;                                           // vertical, rad
  std::array<std::optional<ViewPlace>, saved_views> views{};  // nullopt: not saved
};

/// Returns the rotation of a seat about +y relative to the scene's camera, rad: the first free one of 0,
/// +20°, −20°, +40° …. `taken`: rotations of the occupied seats.
double free_seat_angle(const std::vector<double>& taken);

/// Returns the start for a frame of this aspect ratio (width over height). The points of the anatomy (m,
/// world frame) fill most of it, seen from the direction of the scene's camera; without points: the camera's
/// own view. `heads`: eye positions of the other users.
DeskStart desk_start(const CameraInfo& camera, std::span<const Vec3> anatomy, std::span<const Vec3> heads,
                     double aspect);

}  // namespace prosector
