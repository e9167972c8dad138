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

namespace prosector {

class RecordLabels;
class SoftBody;
struct SoftBodyState;

class Simulation {
 public:
  /// Compiles the scene: meshes, masses, matrices, and the equilibrium under gravity, so that no body sags
  /// when it is first touched. Throws InputError if the scene is invalid.
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
  /// Returns the content hash with which the topology was reported. It does not count temporary refinement.
  std::uint64_t topology_hash(BodyId soft_body) const;
  /// Returns how many times the surface, itself unchanged, was re-embedded in other nodes.
  std::uint64_t rehung(BodyId soft_body) const;
  ContentHash content_hash() const;  // hash of everything compiled

  // ---- Running
  /// Advances one tick. Never throws because of user actions; errors are in the report.
  const StepReport& step(const TickInput& input);
  SimTime time() const;
  RigidBodyState rigid_state(BodyId body) const;
  const SoftBodyState& soft_state(BodyId body) const;
  bool asleep(BodyId body) const;
  const Part& part(BodyId body) const;       // the changes that participants made to the body
  std::span<const HandState> hands() const;  // canonical order
  /// Returns the contacts of the hand in the last tick, the near contacts within `reach` (m), and the
  /// supports of the touched bodies.
  HandSurroundings around(const HandRef& hand, double reach) const;
  std::vector<Panel> panels() const;  // open ones, by participant
  double room_lights() const;         // brightness of all lights except those that bodies carry, 0 … 1
  std::vector<Exchange> exchanges() const;  // of the last tick, in a fixed order
  /// Returns the largest distance of a surface vertex from its equilibrium, m.
  double max_displacement(BodyId soft_body) const;

  /// Hashes every bit that affects the next tick.
  std::uint64_t state_hash() const;
  /// Returns the current state; a CutEvent can rewind to it. Adds the names of the saved values to `labels`.
  std::vector<std::uint8_t> save(RecordLabels* labels = nullptr) const;
  /// Saves the state, restores it from the saved bytes, and returns them. This run and a run that restores
  /// the bytes both rebuild their caches canonically, so they stay equal. Throws InputError, and changes
  /// nothing, if the saved state can't be restored.
  std::vector<std::uint8_t> checkpoint();
  /// Restores a checkpoint. Throws InputError, and changes nothing, when the bytes are no checkpoint of this
  /// compiled scene.
  void restore(std::span<const std::uint8_t> bytes);
  /// Takes over the state of a simulation of the same bodies, of which some are modelled differently
  /// (take_over.h). If the take-over is refused, this simulation's state is undefined.
  Refusal take_over(const Simulation& from);

  struct Impl;  // for the simulation's own files

 private:
  std::unique_ptr<Impl> impl_;
};

/// Returns the number of tetrahedra of all bodies.
std::size_t tet_count(const Simulation& simulation);

}  // namespace prosector
