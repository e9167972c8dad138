#pragma once
// The sides of the room that collide: its floor and walls. They are no bodies of the scene, so that bodies'
// and hands' slots don't depend on them; a contact knows them by slots of their own.

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "common/scene/scene.h"
#include "server/physics/collision/shapes/shape.h"

namespace prosector {

/// All that lies behind it is solid: nothing is so fast that it passes.
struct RoomSide {
  Vec3 point = Vec3::Zero();    // m, on it
  Vec3 normal = Vec3::UnitY();  // unit, along an axis, into the room
};

inline constexpr std::size_t most_room_sides = 5;
inline constexpr double least_behind = 0.005;  // m: what begins less deep in a side is pushed out of it
inline constexpr double room_friction = 0.5;
inline constexpr double room_side_extent = 25;  // m: from its middle, along it; twice as much behind it

/// Sides of the room by bits.
using RoomSides = std::uint32_t;
inline constexpr RoomSides all_room_sides = ~0U;

/// Returns the sides that the scene has, in a fixed order: the floor, then the walls.
std::vector<RoomSide> room_sides(const std::optional<RoomDesc>& room);

/// Returns the side as a box in the room, of which one face is the side.
ShapePart solid_of(const RoomSide& side);

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

/// Returns the sides behind which any of the points lies.
RoomSides sides_before(std::span<const Vec3> points, std::span<const RoomSide> room);

}  // namespace prosector
