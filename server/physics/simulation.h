#pragma once
// The standalone physics, usable without network or session: compile a scene, step it with inputs, read its
// state.
//
// Deterministic: the same binary and the same inputs give the same hash for any thread count, after save and
// restore, and on replay. The step reads no clock. StepReport's times are measured around the step and decide
// nothing.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/hash.h"
#include "common/ids.h"
#include "common/mesh.h"
#include "common/part_messages.h"
#include "common/scene/scene.h"
#include "common/scene_messages.h"
#include "server/physics/base/part.h"
#include "server/physics/base/step_report.h"
#include "server/physics/stations/compile/compile_options.h"
#include "server/physics/world/tick_input.h"
#include "server/physics/world/tick_output.h"

namespace prosector::soft {
class SoftBody;
struct SoftBodyState;
}  // namespace prosector::soft

namespace prosector {

class RecordLabels;

class Simulation {
 public:
  /// Compiles the scene into meshes, masses, matrices, and the equilibrium under gravity, so that no body
  /// sags when it is first touched. Throws InputError if the scene is invalid.
  Simulation(const SceneDesc& scene, const CompileOptions& options);
  ~Simulation();

  // ---- Model
  const SceneDesc& scene() const;
  std::size_t body_count() const;  // rigid bodies first, in scene order, then soft ones
  BodyKind kind(BodyId body) const;
  const std::string& name(BodyId body) const;
  const TriangleMesh& surface(BodyId body) const;  // rigid: body frame; soft: rest shape, world frame
  const soft::SoftBody& soft(BodyId body) const;
  std::uint32_t revision(BodyId soft_body) const;      // of its topology
  const Numbering& numbering(BodyId soft_body) const;  // of soft(body).anatomy()
  /// Returns the content hash (of connectivity, rest shape and masses) with which the body's topology was
  /// reported. Temporary mesh refinement near contacts does not change it.
  std::uint64_t topology_hash(BodyId soft_body) const;
  /// Returns how many times the body's surface, itself unchanged, was embedded in other nodes, because the
  /// mesh below it was refined or coarsened.
  std::uint64_t rehung(BodyId soft_body) const;
  ContentHash content_hash() const;  // hash of everything compiled

  // ---- Running
  /// Advances the simulation by one tick, consuming `input`. Never throws because of user actions; their
  /// errors are in the returned report.
  const StepReport& step(const TickInput& input);
  SimTime time() const;
  RigidBodyState rigid_state(BodyId body) const;
  const soft::SoftBodyState& soft_state(BodyId body) const;
  bool asleep(BodyId body) const;
  const Part& part(BodyId body) const;       // the changes that participants made to the body
  std::span<const HandState> hands() const;  // canonical order
  /// Returns the contacts of the hand in the last tick, the points of other tissue within `reach` (m) of it,
  /// and the supports of the bodies that it touches.
  HandSurroundings around(const HandRef& hand, double reach) const;
  std::vector<Panel> panels() const;  // open ones, by participant
  double room_lights() const;         // brightness of all lights except those that bodies carry, 0 … 1
  std::vector<Exchange> exchanges() const;  // of the last tick, in a fixed order
  /// Returns the largest distance (m) of a vertex of the body's surface from its position at equilibrium
  /// under gravity.
  double max_displacement(BodyId soft_body) const;

  /// Returns a hash of every bit of the state that affects the next tick.
  std::uint64_t state_hash() const;
  /// Returns the current state as bytes, to which a CutEvent can later rewind. Adds the names of the saved
  /// values and their offsets to `labels`, unless that is null.
  std::vector<std::uint8_t> save(RecordLabels* labels = nullptr) const;
  /// Saves the state, restores it from the saved bytes, and returns them. This run rebuilds its caches in the
  /// same way as a run that restores the bytes, so both stay equal. Throws InputError, and changes nothing,
  /// if the saved state can't be restored.
  std::vector<std::uint8_t> checkpoint();
  /// Restores a state that checkpoint() returned. Throws InputError, and changes nothing, if `bytes` are no
  /// checkpoint of this compiled scene.
  void restore(std::span<const std::uint8_t> bytes);
  /// Copies the state of another simulation of the same bodies, of which some are modelled differently here.
  /// If the result is a refusal, this simulation's state is undefined.
  Refusal take_over(const Simulation& from);

  struct Impl;  // for the simulation's own files

 private:
  std::unique_ptr<Impl> impl_;
};

/// Returns the total number of tetrahedra of all soft bodies in the simulation.
std::size_t tet_count(const Simulation& simulation);

}  // namespace prosector
