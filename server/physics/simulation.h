#pragma once
// The physics by itself: usable without network or session. Compile a scene, step it with inputs, read its
// state.
//
// Same binary, same inputs, same hash: for any thread count, after save and restore, on replay. The step
// reads no clock (StepReport's times are measured around it and decide nothing).

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/mesh.h"
#include "common/messages.h"
#include "common/scene/scene.h"
#include "server/physics/contact/contact.h"
#include "server/physics/panel/panel_event.h"
#include "server/physics/part.h"
#include "server/physics/step_report.h"

namespace prosector {

class SoftBody;
struct SoftBodyState;

/// One participant's hand as the step wants it: a target for the virtual coupling. Inputs are ordered by
/// (participant, hand).
struct HandTarget {
  ParticipantId participant = 0;
  std::size_t hand = right_hand;
  Pose target;
  std::array<double, fingers> flexion{};
  bool draws = false;  // a cut, which is one stroke however often the blade leaves tissue meanwhile
  std::optional<double> reaction = {};  // N: with which a haptic arm pushes this hand back; none: no arm does
};

/// Discrete events, journalled with the tick they are consumed in.
struct HandEvent {
  enum class Kind : std::uint8_t { appear, vanish, grasp, release, reset_body, grasp_body, regrasp } kind;
  ParticipantId participant = 0;
  std::size_t hand = right_hand;
  /// What reset_body puts back. What grasp_body and regrasp take where the hand reaches it; else grasp_body
  /// takes what grasp would, and regrasp nothing.
  BodyId body = 0;
};

/// A change of how exactly a soft body is solved: from this tick on less by that many steps (0: as
/// described); see soft/base/effort.h. Whoever shares an island with it decides with it: the one that stepped
/// down least.
struct EffortChange {
  BodyId body = 0;
  int steps_down = 0;
};

/// Where a fixed body is when the tick ends: a press, a clamp, a test machine. On the way it moves evenly,
/// and nothing stops it; in ticks that don't name it, it stands still. What it touches is kept awake.
struct Drive {
  BodyId body = 0;
  Pose pose;  // of the body's frame, in the room
};

/// All that a tick consumes, in canonical order.
struct TickInput {
  std::vector<EffortChange> efforts;
  std::vector<HandEvent> events;
  std::vector<HandTarget> targets;  // of hands present this tick; one without a target holds its last
  std::vector<HeadPlace> heads;     // of those that moved
  std::vector<PanelEvent> panels;   // obeyed after `parts`
  std::vector<HeldPlace> held;      // of tablets and styluses; those that moved, came or went
  std::vector<PartEvent> parts;     // obeyed after `events`; answered in StepReport::part_answers
  std::vector<CutEvent> cuts;       // obeyed after them; answered in StepReport::cut_answers
  std::vector<Drive> drives;        // of programs that use the physics by itself: sessions have none
};

/// Where a physical hand ended up, and what it touches most.
struct HandState {
  ParticipantId participant = 0;
  std::size_t hand = right_hand;
  Pose pose;
  std::array<double, fingers> flexion{};
  std::optional<BodyId> holding;
  ContactSample contact;
};

/// What two bodies did to each other in the last tick, over all points where they touched. It is told of soft
/// bodies with any, and of rigid ones that were solved with soft ones. Hands have their own (HandState).
struct Exchange {
  BodyId a = 0, b = 0;
  std::uint32_t points = 0;     // that pressed
  Vec3 impulse = Vec3::Zero();  // N·s, on a, friction included; on b its opposite
  double normal_impulse = 0;    // N·s, sum over the points, each along its own normal
  double depth = 0;             // m, of the deepest point when the tick began; 0: all were apart
  Vec3 point = Vec3::Zero();    // m, world frame: where it pressed hardest …
  Vec3 normal = Vec3::UnitY();  // … and the unit normal there, from b to a
};

/// A point of a body that a hand meets, or is near.
struct HandTouch {
  BodyId body = 0;
  ContactSide side;               // the point of the body
  Vec3 point = Vec3::Zero();      // m, room: on the hand, when the tick ends
  Vec3 normal = Vec3::UnitY();    // unit, from the body to the hand
  double gap = 0;                 // m, when the tick began; of what presses below 0
  double force = 0;               // N, normal, when the tick ends
  Vec3 exchanged = Vec3::Zero();  // N, on the hand, friction included: mean over the tick
  double stiffness = 0;           // N/m, of the contact by itself, or of one at that point
  double friction = 0;            // coefficient
  Mat3 give = Mat3::Zero();       // m/N: how far that point of the hand yields while its arm stays
  bool holds = false;             // a spring that pulls as well as it presses, any way; or a weight
  double bound = 0;               // N: of what holds, its largest force
};

/// What keeps a point of a soft body in its place: a contact that presses, or a hold.
struct Support {
  BodyId body = 0;
  ContactSide side;
  Mat3 stiffness = Mat3::Zero();  // N/m
  std::optional<HandRef> hand;    // whose it is
};

/// What there is around a hand after a tick.
struct HandSurroundings {
  std::vector<HandTouch> touches;  // what presses on it first
  std::vector<Support> supports;   // of the soft bodies among them, besides their ties; by body
};

struct RigidBodyState {
  Pose pose;  // of the body's own frame (not its centre of mass)
  Vec3 linear_velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();
  bool asleep = false;
};

struct CompileOptions {
  int threads = 0;  // 0: all cores
  std::vector<std::filesystem::path>
      data_dirs;                    // where sources that the scene names are looked up, after its own folder
  std::filesystem::path cache_dir;  // meshes and equilibria by content hash; empty: none
  std::function<void(const std::string&)> progress;  // lines for people
  /// Geometry from the caller (world frame) for the soft bodies it returns some for, instead of the sources
  /// that the scene names.
  std::function<std::optional<Anatomy>(const SoftDesc&)> anatomy;
};

class Simulation {
 public:
  /// Compiles: meshes, masses, matrices, and the equilibrium under gravity, so that nothing sags at first
  /// touch. Throws InputError for what the scene got wrong.
  Simulation(const SceneDesc& scene, const CompileOptions& options);
  ~Simulation();

  // ---- Model
  const SceneDesc& scene() const;
  std::size_t body_count() const;  // rigid bodies first, in scene order, then soft ones
  BodyKind kind(BodyId body) const;
  const std::string& name(BodyId body) const;
  const TriangleMesh& surface(BodyId body) const;  // rigid: body frame; soft: rest shape, world frame
  const SoftBody& soft(BodyId body) const;
  std::uint32_t revision(BodyId soft_body) const;      // of its topology
  const Numbering& numbering(BodyId soft_body) const;  // of soft(body).anatomy()
  /// Returns the content hash that its topology was told with: without the elements that are smaller for now.
  std::uint64_t topology_hash(BodyId soft_body) const;
  /// Returns how often its surface, which stayed what it was, came to hang on other nodes.
  std::uint64_t rehung(BodyId soft_body) const;
  ContentHash content_hash() const;  // of everything compiled

  // ---- Running
  /// Advances one tick. Never throws for what users did; what went wrong is in the report.
  const StepReport& step(const TickInput& input);
  SimTime time() const;
  RigidBodyState rigid_state(BodyId body) const;
  const SoftBodyState& soft_state(BodyId body) const;
  bool asleep(BodyId body) const;
  const Part& part(BodyId body) const;       // what people made of it
  std::span<const HandState> hands() const;  // canonical order
  /// Returns what the hand met in the last tick, or has nearer than `reach` (m), and what bears that.
  HandSurroundings around(const HandRef& hand, double reach) const;
  std::vector<Panel> panels() const;        // open ones, by participant
  double room_lights() const;               // brightness of all lights but those that bodies carry, 0 … 1
  std::vector<Exchange> exchanges() const;  // of the last tick, in a fixed order
  double max_displacement(
      BodyId soft_body) const;  // m: largest distance of a surface vertex from its equilibrium

  /// Hashes every bit that changes the next tick.
  std::uint64_t state_hash() const;
  /// Returns the state as it is, to go back to with a CutEvent.
  std::vector<std::uint8_t> save() const;
  /// Saves the state and restores it from the saved bytes, which it returns. Both this run and one that
  /// restores them rebuild their caches canonically, so they stay equal. Throws InputError, and changes
  /// nothing, if the saved state can't be restored.
  std::vector<std::uint8_t> checkpoint();
  /// Throws InputError, and changes nothing, when the bytes are no checkpoint of this compiled scene.
  void restore(std::span<const std::uint8_t> bytes);
  /// Takes over the state of a simulation of the same bodies, some modelled in another way: take_over.h. If
  /// it is refused, this simulation's state is undefined.
  Refusal take_over(const Simulation& from);

  struct Impl;  // of the simulation's own files

 private:
  std::unique_ptr<Impl> impl_;
};

/// Returns how many tetrahedra all its bodies have.
std::size_t tet_count(const Simulation& simulation);

}  // namespace prosector
