#pragma once
// Where a desk user begins: the anatomy in the picture, and nobody else's seat.

#include <array>
#include <optional>
#include <vector>

#include "client/app/orbit_view.h"
#include "common/messages.h"

namespace prosector {

inline constexpr std::size_t saved_views = 9;  // on the number keys, from 1

struct DeskStart {
  ViewPlace home;
  double fov = 0.8;                                           // vertical, rad
  std::array<std::optional<ViewPlace>, saved_views> views{};  // nullopt: nothing saved
};

/// Returns by how much (rad, about +y) a seat is turned from the scene's camera: the first of 0, +20°, −20°,
/// +40° … that is free. `taken` are the turns of those who sit already.
double free_seat(const std::vector<double>& taken);

/// Returns the start in a picture of that aspect (width over height). The points of the anatomy (m, world
/// frame) fill most of it, seen as the scene's camera sees them; none: the camera's own view. `heads` are the
/// eyes of those who are there.
DeskStart desk_start(const CameraInfo& camera, std::span<const Vec3> anatomy, std::span<const Vec3> heads,
                     double aspect);

}  // namespace prosector
