#pragma once
// A hosted session in one process: a block of tissue and a ball on a table, an in-process network in stepped
// time, and clients that drive it.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "client/replica/replica.h"
#include "idl/local_bus.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/session/run/server_loop.h"
#include "tests/physics/scenes.h"

namespace prosector::test {

inline SceneDesc hosted_scene() {
  SceneDesc scene;
  scene.name = "hosted";
  scene.rigid = {table(), part_body("ball", "sphere", {0.06, 0.06, 0.06}, {0.3, 0.2, 0})};
  scene.soft = {block("liver")};
  scene.session.input_timeout = 0.1;
  return scene;
}

/// A client: its end of the network and what it knows.
struct Guest {
  std::unique_ptr<Bus> bus;
  Replica replica;
  ParticipantId id = 0;
  std::uint64_t sequence = 0;
  std::vector<CommandResult> results;
  /// Returns the last answer to a command: results numbered 0 answer none.
  const CommandResult& answer() const {
    return *std::find_if(results.rbegin(), results.rend(), [](const auto& r) { return r.sequence > 0; });
  }

  void greet(const std::string& name, Role role) {
    Presence p;
    p.participant = id;
    p.name = name;
    p.role = role;
    bus->publish(p);
    command(Join{});
  }
  void command(const CommandBody& body) { bus->publish(Command{id, ++sequence, body}); }
  HandInput hand_at(const Vec3& at) {
    HandInput i;
    i.participant = id;
    i.sequence = ++sequence;
    i.hands[right_hand].tracked = true;
    i.hands[right_hand].pose.p = at;
    return i;
  }
  void take() {
    std::vector<Received> received;
    bus->take(received);
    for (const Received& r : received) {
      if (const auto* result = std::get_if<CommandResult>(&r.message); result && result->participant == id)
        results.push_back(*result);
      replica.apply(r);
    }
  }
};

struct Hosted {
  explicit Hosted(const LocalNetworkConfig& network_config = {}, Journal* journal = nullptr, int threads = 1,
                  const SceneDesc& scene = hosted_scene(), const LoopOptions& loop_options = {})
      : network(network_config),
        simulation(scene, options(threads)),
        bus(network.join(config(BusEnd::server))),
        loop(
            simulation, *bus, "prosector", journal, [this](const std::string& line) { log.push_back(line); },
            loop_options) {}

  LocalNetwork network;
  Simulation simulation;
  std::unique_ptr<Bus> bus;
  std::vector<std::string> log;
  ServerLoop loop;

  static BusConfig config(BusEnd end) {
    BusConfig c;
    c.end = end;
    return c;
  }
  Guest guest(ParticipantId id, BusEnd end) {
    Guest g;
    g.bus = network.join(config(end));
    g.id = id;
    return g;
  }
  void tick() {
    loop.tick();
    loop.publisher().flush();
    network.advance(std::chrono::microseconds(16667));
  }
  static constexpr BodyId liver = 2;
};

/// Where the hand is at tick t of a press: down into the block's top for a second, up and away after.
inline Vec3 press(std::uint64_t t) {
  const double depth = t < 60 ? static_cast<double>(t) / 60 : t < 90 ? 1 : -1;
  return {0, 0.12 - 0.06 * depth, 0.05};
}

/// Largest distance of the guest's drawn surface from the server's.
inline double surface_error(Hosted& hosted, Guest& guest) {
  SoftReplica* soft = guest.replica.bodies().soft(Hosted::liver);
  if (soft == nullptr) return 1;
  soft->sample(static_cast<double>(hosted.simulation.time().tick) + 1, 1.0 / 60);  // the newest it has
  const SparseMap& map = hosted.simulation.soft(Hosted::liver).anatomy().embedding;
  double worst = 0;
  for (std::size_t v = 0; v < map.rows.size(); ++v)
    worst = std::max(worst, (map.apply(v, hosted.simulation.soft_state(Hosted::liver).motion.x.data()) -
                             soft->surface()[v].cast<double>())
                                .norm());
  return worst;
}

}  // namespace prosector::test
