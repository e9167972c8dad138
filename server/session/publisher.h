#pragma once
// Snapshots as samples, on a thread of its own: whatever the network does, the step never waits.
//
// What must arrive (answers, roster) is queued without loss; snapshots are a queue of two, from which the
// stale one is dropped. What is sent of a snapshot depends on what was sent before, not on the snapshots
// between, so a dropped one loses nothing but time.
//
// What hands with an arm feel is sent again and again until there is something newer. So a lost message is
// made up for within milliseconds, and an arm soon knows that the server is gone.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "idl/bus.h"
#include "server/session/hand_sender.h"
#include "server/session/panel_sender.h"
#include "server/session/rigid_sender.h"
#include "server/session/scene_content.h"
#include "server/session/session.h"
#include "server/session/snapshot.h"
#include "server/session/soft_sender.h"

namespace prosector {

struct PublisherCounters {
  std::uint64_t snapshots_sent = 0, snapshots_dropped = 0;
  std::uint64_t unsent = 0;  // samples that the bus could not send
};

class Publisher {
 public:
  /// Publishes the session, the scene, its assets and the topology log, in this order, before any state.
  /// `bus` and `content` outlive the publisher.
  Publisher(Bus& bus, const SessionInfo& info, const SceneContent& content);
  /// Sends what is queued, takes the session off the network, and ends.
  ~Publisher();
  Publisher(const Publisher&) = delete;
  Publisher& operator=(const Publisher&) = delete;

  void say(std::vector<Outgoing> messages);
  void offer(std::shared_ptr<const Snapshot> snapshot);
  /// Waits until everything queued has been sent.
  void flush();
  PublisherCounters counters() const;
  const SessionInfo& info() const { return info_; }

 private:
  Bus& bus_;
  SessionInfo info_;
  const SceneContent& content_;
  std::map<BodyId, RigidSender> rigid_;
  std::map<BodyId, SoftSender> soft_;
  HandSender hands_;
  PanelSender panels_;
  bool newcomer_ = false;
  std::vector<FeltPlanes> felt_;                        // of the newest snapshot
  std::chrono::steady_clock::time_point felt_at_ = {};  // when it was sent first

  mutable std::mutex mutex_;
  std::condition_variable wake_, idle_;
  std::deque<Outgoing> messages_;
  std::deque<std::shared_ptr<const Snapshot>> snapshots_;
  PublisherCounters counters_;
  bool busy_ = true, stop_ = false;
  std::thread thread_;

  void run();
  void announce();
  void send(const Snapshot& snapshot);
  void publish(const Message& message);
  void repeat_felt();
  bool repeats_felt() const;
};

}  // namespace prosector
