#pragma once
// A hand while it is present: its target, its physical body, and what it holds.

#include <optional>
#include <span>
#include <vector>

#include "server/physics/contact/contact.h"
#include "server/physics/contact/pad.h"
#include "server/physics/hands/grip.h"
#include "server/physics/island.h"
#include "server/physics/model.h"

namespace prosector {

/// A hold is points that hand and thing share, kept together by bounded springs.
struct Hold {
  struct Point {
    Vec3 in_hand;              // m, hand's centre-of-mass frame
    Vec3 in_body;              // m, rigid: its centre-of-mass frame
    std::uint32_t vertex = 0;  // soft: surface vertex
    double stiffness = 0;      // N/m
    double max_force = 0;      // N
  };
  BodyId body = 0;
  std::vector<Point> points;
  bool lifted = false;    // it was in the air
  int resting_ticks = 0;  // in a row, on something else, since then
};

struct Hand {
  ParticipantId participant = 0;
  std::size_t side = right_hand;
  std::size_t slot = 0;  // in the rigid world
  Pose target;           // wrist
  Pose previous_target;
  std::array<double, fingers> target_flexion{}, flexion{};
  bool draws = false;              // a cut
  std::optional<double> reaction;  // N, of the haptic arm that moves it; none: no arm does
  std::optional<Hold> hold;
  std::vector<PadMemory> pads;  // as the last tick's contacts come
};

/// Returns the hand in that slot of the rigid world; null: there is none.
const Hand* hand_at(std::span<const Hand> hands, std::size_t slot);

/// Returns whether a hand holds the soft body or touches it. `touches`: its contacts with what is rigid.
bool in_a_hand(std::span<const Hand> hands, BodyId body, std::span<const Contact> touches);

inline constexpr double max_hand_speed = 3;         // m/s, of the effective target
inline constexpr double max_finger_rate = 8;        // 1/s, of flexion: a fist in 1/8 s
inline constexpr double grasp_reach_rigid = 0.03;   // m
inline constexpr double grasp_reach_soft = 0.025;   // m
inline constexpr std::size_t max_hold_points = 24;  // on tissue
inline constexpr double arm_coupling = 5e4;         // N/m, of a hand that an arm moves
inline constexpr double arm_allowance = 1,
                        arm_share = 1.25;  // N, and times its reaction: with which it may press

/// Returns the pull of the virtual coupling for one tick: critically damped towards the target and its speed,
/// force and moment bounded. The effective target is never farther away than max_hand_speed allows. A hand
/// that an arm moves is where the arm is, so that a person feels tissue and not the coupling. It presses with
/// little more than what the arm pushes it back with.
Pull hand_pull(const Hand& hand, const HandModel& model, const HandDesc& desc, const Pose& centre, double h);

/// Returns how far a point of a hand that an arm moves yields under a force on it while the arm stays, m/N.
/// `centre`: the hand's, world frame.
Mat3 coupling_give(const Pose& centre, const Vec3& point);

/// Points on the hand's surface line, world frame, with the radius around each: what a grasp measures from.
struct Feeler {
  Vec3 point;
  double radius;
  std::size_t part;  // of the hand: the palm, then the segments in joint order
};
std::vector<Feeler> feelers(const Hand& hand, const HandModel& model, const Pose& centre);
const Feeler& nearest_feeler(std::span<const Feeler> feelers, const Vec3& point);

/// Makes a hold that pins a rigid body's pose to the hand's by three points around each place that is
/// touched.
Hold hold_rigid(BodyId body, double body_mass, const HandDesc& desc, const Pose& hand_centre,
                const Pose& body_centre, std::span<const Touch> touches, double h);

}  // namespace prosector
