#pragma once
// The physical hand: a palm and finger segments.

#include <array>
#include <vector>

#include "common/hand.h"
#include "common/scene/scene.h"
#include "server/physics/mechanics/contact/rigid_shape.h"
#include "server/physics/mechanics/rigid/rigid_world.h"

namespace prosector::hands {

/// Physical model of a left or right hand as a rigid body whose parts are the palm, then the finger segments
/// in joint order.
struct HandModel {
  contact::RigidShape shape;
  rigid::RigidSetup setup;
  Pose center;  // centre-of-mass frame, relative to the wrist's frame
};

/// Returns the pose of each part of a hand (the palm, then the finger segments in joint order) in the hand's
/// centre-of-mass frame. `hand`: left or right. `flexion` of each finger: 0 straight, 1 bent. `center`: the
/// centre-of-mass frame relative to the wrist.
std::vector<Pose> hand_part_poses(std::size_t hand, const std::array<double, fingers>& flexion,
                                  const Pose& center);

HandModel make_hand_model(std::size_t hand, const HandDesc& desc);

}  // namespace prosector::hands
