#include "server/physics/mechanics/rigid/room.h"

#include <algorithm>

#include "common/room.h"

namespace prosector::rigid {

std::vector<RoomSide> room_sides(const std::optional<RoomDesc>& room) {
  std::vector<RoomSide> out;
  const RoomShape shape;
  if (room && room->floor) out.push_back({Vec3::Zero(), Vec3::UnitY()});
  if (room && room->walls)
    for (const Vec3& inwards : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
      out.push_back({-inwards.cwiseProduct(Vec3(shape.width, 0, shape.depth)) / 2, inwards});
  return out;
}

collision::ShapePart solid_of(const RoomSide& side) {
  collision::ShapePart part;
  part.half = Vec3::Constant(room_side_extent);
  part.pose.p = side.point - room_side_extent * side.normal;
  return part;
}

RoomSides sides_before(std::span<const Vec3> points, std::span<const RoomSide> room) {
  RoomSides out = 0;
  for (std::size_t side = 0; side < room.size(); ++side)
    if (std::any_of(points.begin(), points.end(), [&](const Vec3& x) {
          return room[side].normal.dot(x - room[side].point) < -least_behind;
        }))
      out |= RoomSides{1} << side;
  return out;
}

}  // namespace prosector::rigid
