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

/// Returns the direction of a user's initial view, as an angle about +y from the scene's camera, rad: the
/// first free one of 0, +20°, −20°, +40° …. `taken`: angles of the other users' views.
double free_seat_angle(const std::vector<double>& taken);

/// Returns a user's initial view and the views on the number keys, for a frame of this aspect ratio (width
/// over height). The points of the anatomy (m, world frame) fill most of the frame, seen from the height of
/// the scene's camera. Without points, the distance is that of the scene's camera. `heads`: eye positions of
/// the other users (m, world frame), whose directions are avoided.
DeskStart desk_start(const CameraInfo& camera, std::span<const Vec3> anatomy, std::span<const Vec3> heads,
                     double aspect);

}  // namespace prosector
