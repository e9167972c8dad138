#pragma once
// The physical hand: a palm and finger segments.

#include <array>
#include <vector>

#include "common/hand.h"
#include "common/scene/scene.h"
#include "server/physics/mechanics/contact/rigid_shape.h"
#include "server/physics/mechanics/rigid/rigid_world.h"

namespace prosector {

/// The physical hand of one side: palm, then the segments in joint order.
struct HandModel {
  RigidShape shape;
  RigidSetup setup;
  Pose center;  // centre-of-mass frame, relative to the wrist's frame
};

/// Returns the poses of a hand's parts in its centre-of-mass frame.
std::vector<Pose> hand_part_poses(std::size_t hand, const std::array<double, fingers>& flexion,
                                  const Pose& center);

HandModel make_hand_model(std::size_t hand, const HandDesc& desc);

}  // namespace prosector
