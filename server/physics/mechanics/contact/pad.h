#pragma once
// Finger pads on rigid bodies. A pad is soft: it touches a patch, whose friction also bears a moment about
// the normal. A point contact would let the body spin. The friction of a pad contact therefore acts at three
// points, spread over the patch's ring of friction, each under a third of the normal force. The slips of
// these points are stored, so a pinched body neither creeps nor rotates.

#include <array>
#include <cstdint>
#include <vector>

#include "common/math.h"

namespace prosector::contact {

inline constexpr std::size_t patch_points = 3;

/// Returns the radius (m) of the contact patch of a finger pad with radius `pad_radius` (m) pressed with
/// `force` (N): a³ = 3NR/4E, at most R. It is Hertz' law, the law of soft fingers (Xydas and Kao 1999: a ~
/// N^γ, γ ≤ 1/3) whose pads are linearly elastic.
double contact_radius(double pad_radius, double force);

/// Returns the offsets (m) from the centre of a pad's contact patch to the three points at which its friction
/// acts, at 2/3 of the patch's radius a. Together they bear a moment up to μN·2a/3 about the normal, as an
/// evenly loaded patch does. `along`: unit vector that rotates with the pad and fixes the points' angles.
std::array<Vec3, patch_points> friction_points(const Vec3& normal, const Vec3& along, double radius);

/// State of a finger pad's contact with a rigid body that is stored from one tick to the next. Positions and
/// vectors are in the hand's centre-of-mass frame.
struct PadMemory {
  std::uint32_t part = 0;     // of the hand: index
  std::size_t body = 0;       // the pressed body: slot
  Vec3 place = Vec3::Zero();  // position, m
  double force = 0;           // N, normal
  // As Contact::grip.
  std::array<Vec3, patch_points> grip = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

/// Finds the stored contact of a hand's part (index) with the rigid body in slot `body` that is closest to
/// `place` (m, hand's centre-of-mass frame). Returns null if none is within 3 mm.
const PadMemory* find(const std::vector<PadMemory>& memories, std::uint32_t part, std::size_t body,
                      const Vec3& place);

}  // namespace prosector::contact
