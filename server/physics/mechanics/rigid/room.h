#pragma once
// The colliding sides of the room: floor and walls. They are not bodies of the scene, so the slots of bodies
// and hands don't depend on them. In contacts they have their own slots.

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "common/scene/scene.h"
#include "server/physics/mechanics/collision/shapes/shape.h"

namespace prosector::rigid {

/// Plane side of the room (floor or wall) with which bodies collide. All space behind it is solid, so no body
/// passes it at any speed.
struct RoomSide {
  Vec3 point = Vec3::Zero();    // m, on the side
  Vec3 normal = Vec3::UnitY();  // unit, along an axis, into the room
};

inline constexpr std::size_t most_room_sides = 5;
inline constexpr double least_behind = 0.005;  // m: bodies that start less deep behind a side are pushed out
inline constexpr double room_friction = 0.5;
inline constexpr double room_side_extent = 25;  // m: half its extent; its box extends twice as much behind it

/// Set of room sides, as bits: bit i stands for side i of room_sides().
using RoomSides = std::uint32_t;
inline constexpr RoomSides all_room_sides = ~0U;

/// Returns the sides of the room that the scene has, in a fixed order: the floor, then the four walls.
/// Returns none for a scene without a room.
std::vector<RoomSide> room_sides(const std::optional<RoomDesc>& room);

/// Returns a collision box, in the room frame, for the solid space behind a side of the room. One face of the
/// box is the side.
collision::ShapePart solid_of(const RoomSide& side);

constexpr std::size_t room_slot(std::size_t side) {
  return std::numeric_limits<std::size_t>::max() - 1 - side;
}
constexpr bool is_room(std::size_t slot) {
  return slot >= room_slot(most_room_sides - 1);
}
constexpr std::size_t room_side(std::size_t slot) {
  return room_slot(0) - slot;
}
constexpr bool has_side(RoomSides sides, std::size_t side) {
  return ((sides >> side) & 1U) != 0;
}

/// Returns the set of those sides of the room that have any of the points, in the room frame, more than
/// `least_behind` behind them.
RoomSides sides_before(std::span<const Vec3> points, std::span<const RoomSide> room);

}  // namespace prosector::rigid
