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

namespace prosector::hands {

/// Hold of a hand on a body it grasps: pairs of a point of the hand and a point of the body, connected by
/// springs of bounded force.
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
  std::vector<contact::PadMemory> pads;  // in the order of the last tick's contacts
};

/// Returns the hand that has this slot (index of a body) in the rigid world; null if the slot is not a
/// hand's.
const Hand* hand_at(std::span<const Hand> hands, std::size_t slot);

/// Returns whether any hand holds the body.
bool is_held(std::span<const Hand> hands, BodyId body);

/// Returns whether any hand holds or touches the soft body `body`. `touches`: the soft body's contacts with
/// rigid bodies, hands included.
bool in_a_hand(std::span<const Hand> hands, BodyId body, std::span<const contact::Contact> touches);

inline constexpr double max_hand_speed = 3;         // m/s, of the effective target
inline constexpr double max_finger_rate = 8;        // 1/s, of flexion: a full fist takes 1/8 s
inline constexpr double grasp_reach_rigid = 0.03;   // m
inline constexpr double grasp_reach_soft = 0.025;   // m
inline constexpr std::size_t max_hold_points = 24;  // for tissue
inline constexpr double arm_coupling = 5e4;         // N/m, stiffness for a hand that a haptic arm moves
/// Constants of the force limit of a hand that a haptic arm moves and that holds nothing. The limit is
/// `arm_allowance` (N) plus `arm_share` times the arm's reaction force, and at most the hand's own limit.
inline constexpr double arm_allowance = 1, arm_share = 1.25;

/// Returns the parameters of the virtual coupling that pulls a hand to its tracked pose in a tick of `h` s.
/// The coupling is critically damped and has bounded force and moment. `centre`: the current pose of the
/// hand's centre of mass, world frame. The target is used only up to a distance that max_hand_speed allows.
///
/// A hand that a haptic arm moves is coupled stiffly, so that the user feels the tissue instead of the
/// coupling. Its force is limited to little more than the arm's reaction.
Pull hand_pull(const Hand& hand, const HandModel& model, const HandDesc& desc, const Pose& centre, double h);

/// Returns the compliance, m/N, of the virtual coupling of a hand that a haptic arm holds fixed: the
/// displacement of the hand's `point` per force at it. `centre`: pose of the hand's centre of mass; `point`,
/// m; both in the world frame.
Mat3 coupling_give(const Pose& centre, const Vec3& point);

/// Sample point of a hand, from which the distance of a grasped body is measured. It is on the palm's
/// mid-plane or on a finger segment's axis, in the world frame. `radius`, m, is its distance to the skin.
struct Feeler {
  Vec3 point;
  double radius;
  std::size_t part;  // index of the hand's part: the palm, then the segments in joint order
};
std::vector<Feeler> feelers(const Hand& hand, const HandModel& model, const Pose& centre);
const Feeler& nearest_feeler(std::span<const Feeler> feelers, const Vec3& point);

/// Creates the hold of a hand on a rigid body, which fixes the body's pose relative to the hand. Around each
/// touched point, three springs connect hand and body. `hand_centre`, `body_centre`: poses of the centres of
/// mass, world frame. `body_mass` in kg; `h`: tick length, s.
Hold hold_rigid(BodyId body, double body_mass, const HandDesc& desc, const Pose& hand_centre,
                const Pose& body_centre, std::span<const Touch> touches, double h);

}  // namespace prosector::hands
