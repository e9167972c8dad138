#pragma once
// The network as the rest of Prosector sees it: publish and take plain samples. Implementations: Cyclone DDS
// (idl/cyclone_bus.h) and an in-process one with seeded loss, delay and reordering for tests
// (idl/local_bus.h).

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/messages.h"

namespace prosector {

/// Which end of the star this is. It decides the topics that are written and read, so a client never sees
/// another client's Presence. Who may do what is the session's to say, and roles change while it runs.
enum class BusEnd : std::uint8_t { server, dissector, observer };

enum class Liveness : std::uint8_t { alive, gone };  // gone: disposed, or its writer left or died

/// A sample that passed every check at the edge, or news that its instance is gone (then only the key fields
/// are set). Such news is told once, and only of the process that had said the instance (idl/claims.h).
struct Received {
  Message message;
  Liveness liveness = Liveness::alive;
  // Identifies the remote writer's process; the server ties participants to it. What clients write never has
  // 0.
  std::uint64_t writer = 0;
  std::int64_t arrival_ns = 0;  // monotonic_ns() when it reached this process
};

/// What the edge refused, by reason ("HandInput: pose not finite"), and what it let through.
struct BusCounters {
  std::map<std::string, std::uint64_t> dropped;
  std::uint64_t dropped_total = 0;
  std::uint64_t taken = 0, published = 0;
  std::uint64_t bytes_out = 0, bytes_in = 0;  // serialised payload, without protocol overhead
};

/// Thread safe: one thread may publish while another waits and takes.
class Bus {
 public:
  virtual ~Bus() = default;

  /// Sends one sample. Best-effort topics never block; reliable ones may for at most their blocking time, so
  /// the publisher thread calls them, not the step. Returns false when the sample could not be sent
  /// (counted).
  virtual bool publish(const Message& message) = 0;
  /// Ends a keyed instance that this end wrote (Presence on leaving, RosterEntry of who left): readers get
  /// Liveness::gone.
  virtual void dispose(const Message& message) = 0;
  /// Moves everything that arrived since the last call to `out` (cleared first), in order per topic instance.
  virtual void take(std::vector<Received>& out) = 0;
  /// Blocks until something can be taken or the time is over; returns true if something can.
  virtual bool wait(std::chrono::milliseconds timeout) = 0;
  virtual BusCounters counters() const = 0;
};

/// How far the network reaches. The default never leaves this machine.
struct BusConfig {
  BusEnd end = BusEnd::observer;
  std::string session = "prosector";  // DDS partition
  std::uint32_t domain = 0;           // 0–230
  std::string profile;                // empty: built-in loopback; else a file of deploy/dds
  std::string interface;              // for profiles that name one: "eth0" or an address
  bool arm = false;                   // of a client: it has a haptic arm, and takes part in topics for these
  std::vector<std::string> peers;     // explicit servers, "host" or "host:port"
  std::uint32_t server_index =
      0;  // fixed participant index of the server: its port is 7410 + 250·domain + 2·index
};

}  // namespace prosector
