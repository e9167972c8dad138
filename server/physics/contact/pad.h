#pragma once
// Finger pads on rigid things. A pad is soft: what it touches is a patch, which by friction also bears a
// moment about its normal, where a point would let the thing spin. The friction of a contact is therefore
// that of three points spread over the patch's ring of friction, each under a third of the normal force.
// Their slips are remembered, so that what a hand pinches neither creeps nor turns in it.

#include <array>
#include <cstdint>
#include <vector>

#include "common/math.h"

namespace prosector {

inline constexpr std::size_t patch_points = 3;

/// Returns the radius (m) of the patch of a pad with that radius (m) under that force (N): a³ = 3NR/4E, and
/// no more than R. Hertz' law, which is that of soft fingers (Xydas and Kao 1999: a ~ N^γ, γ ≤ 1/3) whose
/// pads are linearly elastic.
double contact_radius(double pad_radius, double force);

/// Returns where, from the patch's middle, its friction acts: 2a/3 away. So together the points bear up to
/// μN·2a/3 about the normal, as an evenly loaded patch of radius a does. `along`: unit; turns with the pad.
std::array<Vec3, patch_points> friction_points(const Vec3& normal, const Vec3& along, double radius);

/// What a pad's contact remembers from one tick to the next. Frame: the hand's centre of mass.
struct PadMemory {
  std::uint32_t part = 0;     // of the hand …
  std::size_t body = 0;       // … and what it pressed: slot
  Vec3 place = Vec3::Zero();  // m
  double force = 0;           // N, normal
  // As Contact::grip.
  std::array<Vec3, patch_points> grip = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

/// Finds the memory of that pad on that body that is nearest, null: there is none near.
const PadMemory* find(const std::vector<PadMemory>& memories, std::uint32_t part, std::size_t body,
                      const Vec3& place);

}  // namespace prosector
