#pragma once
// An instrument's blade as a hand leads it.

#include <optional>

#include "client/replica/replica.h"

namespace prosector {

/// A blade in some frame. It is drawn `ahead`, with its tip foremost or not.
struct BladeFrame {
  Vec3 tip = Vec3::Zero();      // m
  Vec3 along = -Vec3::UnitZ();  // unit: along the edge to the tip
  Vec3 ahead = -Vec3::UnitX();  // unit, at right angles to that: where the edge looks
  double length = 0;            // m, of the edge
};

/// Returns the blade by the longest of the body's edges, in the body's frame. nullopt: it has none.
std::optional<BladeFrame> blade_frame(const RigidReplica& body);

/// Returns the blade in the frame to which the pose leads.
BladeFrame operator*(const Pose& pose, const BladeFrame& blade);

}  // namespace prosector
