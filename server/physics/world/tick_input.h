#pragma once
// The inputs that one tick of a simulation consumes.

#include <array>
#include <optional>
#include <vector>

#include "common/hand_pose.h"
#include "common/ids.h"
#include "common/math.h"
#include "server/physics/base/part.h"
#include "server/physics/base/topology.h"
#include "server/physics/mechanics/panel/panel_event.h"

namespace prosector {

/// Target of one participant's hand in a tick: the tracked pose and finger flexion to which the virtual
/// coupling pulls the simulated hand. Inputs are ordered by (participant, hand).
struct HandTarget {
  ParticipantId participant = 0;
  std::size_t hand = right_hand;
  Pose target;
  std::array<double, fingers> flexion{};
  bool draws = false;                   // draws a cut: one stroke, even if the blade leaves tissue meanwhile
  std::optional<double> reaction = {};  // N: force of a haptic arm on this hand; none: no arm is connected
};

/// A discrete event of a participant's hand, such as grasping. Events are recorded in the journal with the
/// tick that consumes them.
struct HandEvent {
  enum class Kind : std::uint8_t { appear, vanish, grasp, release, reset_body, grasp_body, regrasp } kind;
  ParticipantId participant = 0;
  std::size_t hand = right_hand;
  /// Body that the event concerns. For reset_body it is the body to reset. For grasp_body and regrasp it is
  /// the body to grasp if the hand reaches it. If it is out of reach, grasp_body grasps like `grasp`, and
  /// regrasp does nothing.
  BodyId body = 0;
};

/// A change of the effort with which a soft body is solved from this tick on. `steps_down` is the number of
/// reductions from the effort in the scene (0: none); see soft/base/effort.h. Bodies in one island (a set of
/// bodies solved together) use the smallest reduction among them.
struct EffortChange {
  BodyId body = 0;
  int steps_down = 0;
};

/// Target pose, at the end of the tick, of a kinematic body (a press, a clamp, a test machine). The body
/// moves there at constant velocity and nothing stops it. In a tick without a KinematicTarget it does not
/// move. Bodies that it touches stay awake.
struct KinematicTarget {
  BodyId body = 0;
  Pose pose;  // of the body's frame, in the room frame
};

/// All inputs that one tick of the simulation consumes, in canonical order.
struct TickInput {
  std::vector<EffortChange> efforts;
  std::vector<HandEvent> events;
  std::vector<HandTarget> targets;      // of hands present this tick; a hand without a target keeps its last
  std::vector<panel::HeadPlace> heads;  // of heads that moved
  std::vector<panel::PanelEvent> panels;  // applied after `parts`
  std::vector<panel::HeldPlace> held;     // of tablets and styluses that moved, appeared or vanished
  std::vector<PartEvent> parts;           // applied after `events`; answered in StepReport::part_answers
  std::vector<CutEvent> cuts;  // applied at the end of the tick; answered in StepReport::cut_answers
  std::vector<KinematicTarget>
      kinematic_targets;  // for programs that use the standalone physics; sessions have none
};

}  // namespace prosector
