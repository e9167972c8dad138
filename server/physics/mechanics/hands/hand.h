#pragma once
// A hand while it is present: its target, its physical body, and its hold.

#include <optional>
#include <span>
#include <vector>

#include "common/ids.h"
#include "server/physics/mechanics/contact/contact.h"
#include "server/physics/mechanics/contact/pad.h"
#include "server/physics/mechanics/hands/grip.h"
#include "server/physics/mechanics/hands/hand_model.h"
#include "server/physics/mechanics/hands/pull.h"

namespace prosector {

/// A hold of a hand on a body: pairs of points that are kept together by bounded springs.
struct Hold {
  struct Point {
    Vec3 in_hand;              // m, hand's centre-of-mass frame
    Vec3 in_body;              // m, rigid: the body's centre-of-mass frame
    std::uint32_t vertex = 0;  // soft: surface vertex
    double stiffness = 0;      // N/m
    double max_force = 0;      // N
  };
  BodyId body = 0;
  std::vector<Point> points;
  bool lifted = false;    // whether the body was lifted into the air
  int resting_ticks = 0;  // number of consecutive ticks on another body since then
};

struct Hand {
  ParticipantId participant = 0;
  std::size_t side = right_hand;
  std::size_t slot = 0;  // in the rigid world
  Pose target;           // of the wrist
  Pose previous_target;
  std::array<double, fingers> target_flexion{}, flexion{};
  bool draws = false;              // whether the hand draws a cut
  std::optional<double> reaction;  // N, of the haptic arm that moves the hand; none: no arm
  std::optional<Hold> hold;
  std::vector<PadMemory> pads;  // in the order of the last tick's contacts
};

/// Returns the hand with that slot of the rigid world; null: none.
const Hand* hand_at(std::span<const Hand> hands, std::size_t slot);

/// Returns whether a hand holds or touches the soft body. `touches`: the body's contacts with rigid bodies.
bool in_a_hand(std::span<const Hand> hands, BodyId body, std::span<const Contact> touches);

inline constexpr double max_hand_speed = 3;         // m/s, of the effective target
inline constexpr double max_finger_rate = 8;        // 1/s, of flexion: a full fist takes 1/8 s
inline constexpr double grasp_reach_rigid = 0.03;   // m
inline constexpr double grasp_reach_soft = 0.025;   // m
inline constexpr std::size_t max_hold_points = 24;  // for tissue
inline constexpr double arm_coupling = 5e4;         // N/m, stiffness for a hand that a haptic arm moves
/// Force limit of a hand that a haptic arm moves: arm_allowance (N) plus arm_share times the arm's reaction.
inline constexpr double arm_allowance = 1, arm_share = 1.25;

/// Returns the pull of the virtual coupling for one tick: critically damped towards the target's pose and
/// velocity, with bounded force and moment. The effective target is never farther away than max_hand_speed
/// allows. A hand that a haptic arm moves follows the arm stiffly, so the user feels tissue instead of the
/// coupling. Its force is limited to little more than the arm's reaction.
Pull hand_pull(const Hand& hand, const HandModel& model, const HandDesc& desc, const Pose& centre, double h);

/// Returns the compliance of a point of a hand that a haptic arm moves while the arm is fixed, m/N. `centre`:
/// the hand's pose, world frame.
Mat3 coupling_give(const Pose& centre, const Vec3& point);

/// A sample point of a hand, from which grasps measure distances: on the palm's mid-plane or a segment's
/// axis. World frame; `radius` is the distance to the skin.
struct Feeler {
  Vec3 point;
  double radius;
  std::size_t part;  // index of the hand's part: the palm, then the segments in joint order
};
std::vector<Feeler> feelers(const Hand& hand, const HandModel& model, const Pose& centre);
const Feeler& nearest_feeler(std::span<const Feeler> feelers, const Vec3& point);

/// Creates a hold that fixes a rigid body's pose relative to the hand, by three points around each touched
/// point.
Hold hold_rigid(BodyId body, double body_mass, const HandDesc& desc, const Pose& hand_centre,
                const Pose& body_centre, std::span<const Touch> touches, double h);

}  // namespace prosector
