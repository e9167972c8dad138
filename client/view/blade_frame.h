#pragma once
// Tip, edge direction and length of a hand-held blade.

#include <optional>

#include "client/replica/replica.h"

namespace prosector {

/// Geometry of a straight blade in some frame: tip, edge and facing direction. It cuts when it is drawn in
/// the direction `ahead`, with or without its tip in front.
struct BladeFrame {
  Vec3 tip = Vec3::Zero();      // m
  Vec3 along = -Vec3::UnitZ();  // unit: along the edge to the tip
  Vec3 ahead = -Vec3::UnitX();  // unit, perpendicular to `along`: the direction the edge faces
  double length = 0;            // m, length of the edge
};

/// Returns the geometry of the body's longest cutting edge, in the body's frame; nullopt if the body has no
/// cutting edge.
std::optional<BladeFrame> blade_frame(const RigidReplica& body);

/// Transforms the blade's geometry from the frame whose pose is given to the frame in which the pose is
/// given.
BladeFrame operator*(const Pose& pose, const BladeFrame& blade);

}  // namespace prosector
