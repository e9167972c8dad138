#pragma once
// Shared state of a LocalNetwork: its ends, samples in transit, and samples stored for late joiners.

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <random>
#include <vector>

#include "idl/counters.h"
#include "idl/instance_owners.h"
#include "idl/local_bus.h"
#include "idl/rate_gate.h"

namespace prosector {

struct LocalNetwork::Hub {
  struct Sample {
    Received received;
    std::size_t bytes = 0;
    std::uint64_t sequence = 0;  // within its lane
  };
  struct End {
    BusConfig config;
    std::uint64_t id = 0;
    bool alive = true;
    std::multimap<std::int64_t, Sample> in_transit;  // by arrival time
    std::vector<Sample> arrived;                     // in order of arrival, after keep-last
    std::map<std::tuple<std::uint64_t, std::size_t, std::size_t>, std::uint64_t>
        last_sequence;                                                           // by writer, topic, lane
    std::map<std::pair<std::uint64_t, std::size_t>, std::int64_t> last_arrival;  // reliable samples
    std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> written;        // count, by topic and lane
    std::map<std::pair<std::size_t, InstanceKey>, std::deque<Sample>> kept;      // for late joiners
    RateGate gate;
    InstanceOwners claims;
    EdgeCounters counters;
    bool has_arm() const { return config.arm || config.end == BusEnd::server; }
  };

  explicit Hub(const LocalNetworkConfig& network) : config(network), random(network.seed) {}

  // All require `mutex` to be held.
  std::int64_t now() const;
  std::shared_ptr<End> join(const BusConfig& end);
  bool publish(End& from, const Message& message);
  void dispose(End& from, const Message& message);
  void leave(End& from, std::int64_t noticed_after_ns);
  void collect_arrivals(End& end);

  LocalNetworkConfig config;
  std::mt19937_64 random;
  std::int64_t stepped_ns = 0;
  std::uint64_t last_id = 0;
  std::vector<std::shared_ptr<End>> ends;
  mutable std::mutex mutex;
  std::condition_variable changed;

 private:
  void send(End& to, Sample sample);
  void send_to_readers(End& from, const Sample& sample);
  void deliver(End& to, Sample sample);
  bool lost();
  std::int64_t transit_ns();
  static bool meet(const End& writer, const End& reader, std::size_t topic);
};

}  // namespace prosector
