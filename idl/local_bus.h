#pragma once
// The Bus inside one process, for tests: the same star, keys, histories and late joining as over DDS, and a
// network whose loss, delay and reordering follow from a seed. Samples pass idl/wire, so they are checked and
// quantised as on the wire.

#include <chrono>
#include <cstdint>
#include <memory>

#include "idl/bus.h"

namespace prosector {

struct LocalNetworkConfig {
  std::uint64_t seed = 1;
  double loss = 0;                     // share of transmissions lost; reliable ones are then repeated
  std::chrono::microseconds delay{0};  // one way
  std::chrono::microseconds jitter{
      0};               // uniform in ±jitter; overtaken best-effort samples are lost, as in DDS
  bool stepped = true;  // time stands still but for advance(), wait() returns at once; else the real clock
};

/// Ends may outlive the network object, and may be used from several threads.
class LocalNetwork {
 public:
  explicit LocalNetwork(const LocalNetworkConfig& config);
  ~LocalNetwork();

  /// Joins; domain and session must be the same for ends to hear each other. Throws InputError when a
  /// server's index is taken. Destroying the bus is leaving.
  std::unique_ptr<Bus> join(const BusConfig& config);
  /// Stops the end as if its process were killed: the others notice when its lease runs out.
  void crash(Bus& bus);

  void advance(std::chrono::nanoseconds time);
  std::int64_t now_ns() const;

  struct Hub;

 private:
  std::shared_ptr<Hub> hub_;
};

}  // namespace prosector
