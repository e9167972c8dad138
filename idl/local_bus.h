#pragma once
// In-process Bus for tests, with the same topology, keys, histories and late joining as DDS. Loss, delay and
// reordering of its network depend on a seed only. Samples pass idl/wire, so they are checked and quantised
// as on a real network.

#include <chrono>
#include <cstdint>
#include <memory>

#include "idl/bus.h"

namespace prosector {

struct LocalNetworkConfig {
  std::uint64_t seed = 1;
  double loss = 0;                     // fraction of transmissions lost; reliable ones are repeated
  std::chrono::microseconds delay{0};  // one way
  std::chrono::microseconds jitter{
      0};               // uniform in ±jitter; overtaken best-effort samples are lost, as in DDS
  bool stepped = true;  // time advances only by advance(), wait() doesn't block; false: real clock
};

/// Simulated network in this process, for tests. The buses that it creates may outlive it and may be used
/// from several threads.
class LocalNetwork {
 public:
  explicit LocalNetwork(const LocalNetworkConfig& config);
  ~LocalNetwork();

  /// Creates a bus that is connected to the simulated network. Only buses of equal domain and session can
  /// communicate. Throws InputError if a server's index is taken. Destroying the bus leaves the network.
  std::unique_ptr<Bus> join(const BusConfig& config);
  /// Stops the bus as if its process were killed: the other buses notice when its liveliness lease expires.
  void crash(Bus& bus);

  void advance(std::chrono::nanoseconds time);
  std::int64_t now_ns() const;

  struct Hub;

 private:
  std::shared_ptr<Hub> hub_;
};

}  // namespace prosector
