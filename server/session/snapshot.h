#pragma once
// Everything that clients may know of one tick; made after the step, never changed, read by the publisher's
// thread.

#include <memory>
#include <optional>
#include <vector>

#include "common/messages.h"
#include "server/physics/simulation.h"
#include "server/session/session.h"
#include "server/session/topology_log.h"

namespace prosector {

struct RigidSnapshot {
  BodyId body = 0;
  RigidBodyState state;
};

struct SoftSnapshot {
  BodyId body = 0;
  bool asleep = false;
  std::uint32_t revision = 0;
  std::shared_ptr<const VecX> x, v;               // of all nodes; a sleeping body shares its last snapshot's
  std::shared_ptr<const SurfaceStream> stream;    // of this revision
  std::uint64_t rehung = 0;                       // as Simulation::rehung()
  std::shared_ptr<const SparseMap> sources = {};  // of one that was; else null: the stream's
};

struct Snapshot {
  SimTime time;
  std::vector<RigidSnapshot> rigid;  // bodies that can move
  std::vector<SoftSnapshot> soft;
  std::vector<UserState> users;
  std::vector<ContactSample> contacts;
  std::vector<FeltPlanes> felt;  // of hands that arms move
  std::vector<Panel> panels;     // open ones
  double lights = 1;             // the room's
  double pace = 1;               // of simulated time
  std::optional<ServerStatus> status;
};

/// Takes a snapshot. `topology` has followed the simulation to now; `previous` lends the shapes of bodies
/// that slept since; may be null.
std::shared_ptr<Snapshot> take_snapshot(const Simulation& simulation, const Session& session,
                                        const TopologyLog& topology, const Snapshot* previous);

}  // namespace prosector
