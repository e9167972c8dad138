#pragma once
// Finger pads on rigid bodies. A pad is soft: it touches a patch, whose friction also bears a moment about
// the normal. A point contact would let the body spin. The friction of a pad contact therefore acts at three
// points, spread over the patch's ring of friction, each under a third of the normal force. The slips of
// these points are stored, so a pinched body neither creeps nor rotates.

#include <array>
#include <cstdint>
#include <vector>

#include "common/math.h"

namespace prosector {

inline constexpr std::size_t patch_points = 3;

/// Returns the contact radius (m) of a pad of that radius (m) under that force (N): a³ = 3NR/4E, at most R.
/// It is Hertz' law, the law of soft fingers (Xydas and Kao 1999: a ~ N^γ, γ ≤ 1/3) whose pads are linearly
/// elastic.
double contact_radius(double pad_radius, double force);

/// Returns the offsets of the friction points from the patch's centre: at 2a/3. Together the points bear up
/// to μN·2a/3 about the normal, as an evenly loaded patch of radius a does. `along`: unit; rotates with the
/// pad.
std::array<Vec3, patch_points> friction_points(const Vec3& normal, const Vec3& along, double radius);

/// Stored state of a pad contact. Frame: the hand's centre of mass.
struct PadMemory {
  std::uint32_t part = 0;     // of the hand: index
  std::size_t body = 0;       // the pressed body: slot
  Vec3 place = Vec3::Zero();  // position, m
  double force = 0;           // N, normal
  // As Contact::grip.
  std::array<Vec3, patch_points> grip = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

/// Finds the memory of that pad on that body that is nearest to `place`, if within 3 mm; null: none.
const PadMemory* find(const std::vector<PadMemory>& memories, std::uint32_t part, std::size_t body,
                      const Vec3& place);

}  // namespace prosector
