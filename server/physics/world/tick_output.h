#pragma once
// Results of a tick, besides the states of the bodies.

#include <array>
#include <optional>
#include <vector>

#include "common/hand_messages.h"
#include "common/hand_pose.h"
#include "common/ids.h"
#include "common/math.h"
#include "server/physics/mechanics/contact/contact.h"

namespace prosector {

/// Pose of a simulated hand at the end of the tick, its finger flexion, the body that it holds, and its
/// strongest contact.
struct HandState {
  ParticipantId participant = 0;
  std::size_t hand = right_hand;
  Pose pose;
  std::array<double, fingers> flexion{};
  std::optional<BodyId> holding;
  ContactSample contact;
};

/// Impulse, depth and contact point between two bodies in the last tick, over all their contact points. There
/// is one for each pair in contact with a soft body, and for rigid bodies that were solved together with soft
/// ones. Contacts of hands are reported in HandState.
struct Exchange {
  BodyId a = 0, b = 0;
  std::uint32_t points = 0;     // number of points that pressed
  Vec3 impulse = Vec3::Zero();  // N·s, on a, friction included; on b the opposite
  double normal_impulse = 0;    // N·s, sum over the points, each along its own normal
  double depth = 0;             // m, of the deepest point at the tick's start; 0: no point penetrated
  Vec3 point = Vec3::Zero();    // m, world frame: the point with the largest force
  Vec3 normal = Vec3::UnitY();  // unit normal at that point, from b to a
};

/// A point of a body that a hand touches, holds, or is near to, as rendered by a haptic arm.
struct HandTouch {
  BodyId body = 0;
  contact::ContactSide side;      // the point of the body
  Vec3 point = Vec3::Zero();      // m, room frame: on the hand, at the tick's end
  Vec3 normal = Vec3::UnitY();    // unit, from the body to the hand
  double gap = 0;                 // m, at the tick's start; < 0 if the contact presses
  double force = 0;               // N, normal, at the tick's end
  Vec3 exchanged = Vec3::Zero();  // N, on the hand, friction included: mean over the tick
  double stiffness = 0;           // N/m, of the contact alone, or of a contact at that point
  double friction = 0;            // coefficient
  Mat3 give = Mat3::Zero();       // m/N: compliance of that point of the hand while its arm stays fixed
  bool holds = false;             // a bilateral spring that acts in every direction; or a weight
  double bound = 0;               // N: largest force of a hold
};

/// A support of a point of a soft body: a contact that presses it or a hand that holds it, with its
/// stiffness.
struct Support {
  BodyId body = 0;
  contact::ContactSide side;
  Mat3 stiffness = Mat3::Zero();  // N/m
  std::optional<HandRef> hand;    // whose hand or held tool supports it
};

/// Bodies around a hand after a tick, for a haptic arm: the points that it touches or is near to, and the
/// supports of the touched soft bodies.
struct HandSurroundings {
  std::vector<HandTouch> touches;  // contacts and holds of the tick first, then near points
  std::vector<Support> supports;   // contacts and holds of the touched soft bodies; by body
};

struct RigidBodyState {
  Pose pose;  // of the body's own frame (not of its centre of mass)
  Vec3 linear_velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();
  bool asleep = false;
};

}  // namespace prosector
