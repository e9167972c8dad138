#pragma once
// Contact plane: local linear model of a contact force, computed by the coupled solver at one point of a
// hand. A client evaluates it at 1 kHz, so that the haptic loop contains no network delay.
//
// With p the position of the hand's point, penetration s = (point − p)·normal, and t the in-plane component
// of p − point:
//   normal force       F = force·normal + stiffness·s − damping·ṗ·normal, at least 0 unless `holds`
//   tangential force   F = (in-plane component of `force`) − tangential·t,
//                      at most friction times the normal force unless `holds`

#include <cstddef>
#include <cstdint>

#include "common/math.h"

namespace prosector {

inline constexpr std::size_t max_contact_planes = 4;  // per hand
inline constexpr double max_plane_force = 1000;       // N
inline constexpr double max_plane_stiffness = 1e6;    // N/m
inline constexpr double max_plane_damping = 1e4;      // N·s/m
inline constexpr double max_plane_friction = 10;
inline constexpr double max_plane_speed = 10;  // m/s

struct ContactPlane {
  std::uint32_t id = 0;          // persistent while the hand touches the same body from the same side
  std::uint32_t body = 0;        // BodyId of the touched body
  Vec3 arm = Vec3::Zero();       // m, hand frame: the hand's contact point
  Vec3 point = Vec3::Zero();     // m, room frame: position of that point at which the force is `force`
  Vec3 normal = {0, 1, 0};       // unit, out of the touched body
  Vec3 force = Vec3::Zero();     // N, on the hand
  double stiffness = 0;          // N/m, along the normal
  double tangential = 0;         // N/m, along the plane
  double damping = 0;            // N·s/m, along the normal
  double friction = 0;           // coefficient of Coulomb's law
  double radius = 0;             // m: range of validity; with `holds`, the model yields beyond it
  Vec3 velocity = Vec3::Zero();  // m/s, of the surface, without the motion that this hand causes
  bool holds = false;            // the hand holds the body: tensile forces are allowed, friction has no bound
};

}  // namespace prosector
