#pragma once
// Network interface of Prosector: publishes and receives plain messages. Implementations: Cyclone DDS
// (idl/cyclone_bus.h), and an in-process network with seeded loss, delay and reordering for tests
// (idl/local_bus.h).

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "idl/message.h"

namespace prosector {

/// Role of this process on the network, in which clients communicate with the server only. It determines the
/// topics that are written and read, so a client never receives another client's Presence. Permissions are
/// checked by the session, since roles change while it runs.
enum class BusEnd : std::uint8_t { server, dissector, observer };

enum class Liveness : std::uint8_t { alive, gone };  // gone: disposed, or its writer left or died

/// A sample that passed all wire checks, or the notification that its instance is gone (then only the
/// message's key fields are set). The notification is sent once, and only if it comes from the process that
/// published the instance (idl/instance_owners.h).
struct Received {
  Message message;
  Liveness liveness = Liveness::alive;
  // Id of the remote writer's process; the server ties participants to it. Never 0 for samples from clients.
  std::uint64_t writer = 0;
  std::int64_t arrival_ns = 0;  // monotonic_ns() when it reached this process
};

/// Counters of a Bus: samples that the wire checks dropped, by reason (such as "HandInput: pose not finite"),
/// samples received and sent, and bytes.
struct BusCounters {
  std::map<std::string, std::uint64_t> dropped;
  std::uint64_t dropped_total = 0;
  std::uint64_t taken = 0, published = 0;
  std::uint64_t bytes_out = 0, bytes_in = 0;  // serialised payload, without protocol overhead
};

/// Abstract interface that publishes and receives messages. Thread safe: one thread may publish while another
/// waits and takes.
class Bus {
 public:
  virtual ~Bus() = default;

  /// Sends one message. Best-effort topics never block. Reliable ones may block up to their blocking time, so
  /// they are called from the publisher thread, not from the simulation step. Returns false if the message
  /// could not be sent, and counts it.
  virtual bool publish(const Message& message) = 0;
  /// Ends a keyed DDS instance that this process wrote, such as the Presence or RosterEntry of a leaving
  /// participant. Only the message's key fields are used. Readers receive Liveness::gone.
  virtual void dispose(const Message& message) = 0;
  /// Moves all samples that were received since the last call to `out` (cleared first). Samples of one topic
  /// instance are in order.
  virtual void take(std::vector<Received>& out) = 0;
  /// Blocks until a received sample is available or the timeout expires. Returns whether a sample is
  /// available.
  virtual bool wait(std::chrono::milliseconds timeout) = 0;
  virtual BusCounters counters() const = 0;
};

/// Network configuration of a Bus. The default never leaves this machine.
struct BusConfig {
  BusEnd end = BusEnd::observer;
  std::string session = "prosector";  // DDS partition
  std::uint32_t domain = 0;           // 0–230
  std::string profile;                // empty: built-in loopback profile; else a file of deploy/dds
  std::string interface;              // for profiles that require one: "eth0" or an address
  bool arm = false;                   // clients only: has a haptic arm, and takes part in the topics for arms
  std::vector<std::string> peers;     // explicit server addresses, "host" or "host:port"
  std::uint32_t server_index = 0;  // of the server's DDS participant; its port is 7410 + 250·domain + 2·index
};

}  // namespace prosector
