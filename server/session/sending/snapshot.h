#pragma once
// State of one tick for clients. It is made after the step, never changed, and read by the publisher's
// thread.

#include <memory>
#include <optional>
#include <vector>

#include "common/hand_messages.h"
#include "common/ids.h"
#include "common/part_messages.h"
#include "common/status_messages.h"
#include "server/physics/simulation.h"
#include "server/session/people/session.h"
#include "server/session/sending/topology_log.h"

namespace prosector {

struct RigidSnapshot {
  BodyId body = 0;
  RigidBodyState state;
};

struct SoftSnapshot {
  BodyId body = 0;
  bool asleep = false;
  std::uint32_t revision = 0;
  std::shared_ptr<const VecX> x, v;  // of all nodes; a sleeping body shares those of its last snapshot
  std::shared_ptr<const SurfaceStream> stream;    // of this revision
  std::uint64_t rehung = 0;                       // as in Simulation::rehung()
  std::shared_ptr<const SparseMap> sources = {};  // if rehung > 0; null: use the stream's
};

struct Snapshot {
  SimTime time;
  std::vector<RigidSnapshot> rigid;  // bodies that can move
  std::vector<SoftSnapshot> soft;
  std::vector<UserState> users;
  std::vector<ContactSample> contacts;
  std::vector<FeltPlanes> felt;  // for hands that haptic arms move
  std::vector<Panel> panels;     // open panels
  double lights = 1;             // brightness of the room's lights
  double pace = 1;               // of simulated time
  std::optional<ServerStatus> status;
};

/// Makes a snapshot of the simulation's current state for clients. `topology` must already have processed the
/// last step's changes. `previous` provides the shapes of bodies that slept since; it may be null.
std::shared_ptr<Snapshot> take_snapshot(const Simulation& simulation, const Session& session,
                                        const TopologyLog& topology, const Snapshot* previous);

}  // namespace prosector
