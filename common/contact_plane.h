#pragma once
// What a hand feels at one place: the tissue there as the coupled solver has it, to first order. A client
// renders it a thousand times a second, so no delay is in the loop that its hand closes.
//
// With p the hand's point, s = (point − p)·normal how far it is in, and t what of p − point lies in the
// plane:
//   along the normal   F = force·normal + stiffness·s − damping·ṗ·normal, never below 0 unless it holds
//   along the plane    F = what of `force` lies in it − tangential·t, at most friction times the normal force

#include <cstddef>
#include <cstdint>

#include "common/math.h"

namespace prosector {

inline constexpr std::size_t max_contact_planes = 4;  // of one hand at once
inline constexpr double max_plane_force = 1000;       // N
inline constexpr double max_plane_stiffness = 1e6;    // N/m
inline constexpr double max_plane_damping = 1e4;      // N·s/m
inline constexpr double max_plane_friction = 10;
inline constexpr double max_plane_speed = 10;  // m/s

struct ContactPlane {
  std::uint32_t id = 0;          // the same as long as the hand touches the same thing from the same side
  std::uint32_t body = 0;        // BodyId of what is touched
  Vec3 arm = Vec3::Zero();       // m, in the hand's frame: the point that is pressed
  Vec3 point = Vec3::Zero();     // m, room: where that point is under `force`
  Vec3 normal = {0, 1, 0};       // unit, out of what is touched
  Vec3 force = Vec3::Zero();     // N, on the hand
  double stiffness = 0;          // N/m, along the normal
  double tangential = 0;         // N/m, along the plane
  double damping = 0;            // N·s/m, along the normal
  double friction = 0;           // coefficient of Coulomb's law
  double radius = 0;             // m: how far it holds; what `holds` yields once it is moved by more
  Vec3 velocity = Vec3::Zero();  // m/s, of the surface, without what this hand does to it
  bool holds = false;            // the hand holds it: it pulls, too, and friction has no bound
};

}  // namespace prosector
