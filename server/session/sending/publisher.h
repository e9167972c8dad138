#pragma once
// Publishes snapshots as samples on a separate thread: the step never waits for the network.
//
// Messages that must arrive (answers, roster) are queued without loss. Snapshots are in a queue of two, from
// which the older one is dropped. The samples of a snapshot depend on what was sent before, not on the
// snapshots in between, so a dropped one loses nothing but time.
//
// Contact planes for haptic arms are sent repeatedly until there are newer ones. So a lost message is
// replaced within milliseconds, and an arm soon detects that the server is gone.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "idl/bus.h"
#include "server/session/people/session.h"
#include "server/session/sending/hand_sender.h"
#include "server/session/sending/panel_sender.h"
#include "server/session/sending/rigid_sender.h"
#include "server/session/sending/scene_content.h"
#include "server/session/sending/snapshot.h"
#include "server/session/sending/soft_sender.h"

namespace prosector {

struct PublisherCounters {
  std::uint64_t snapshots_sent = 0, snapshots_dropped = 0;
  std::uint64_t unsent = 0;  // samples that the bus could not send
};

class Publisher {
 public:
  /// Starts the thread, which first publishes the session, the scene, the topology log and the assets, in
  /// this order, and then states. `bus` must outlive the publisher.
  Publisher(Bus& bus, const SessionInfo& info, std::shared_ptr<const SceneContent> content);
  /// Sends all queued messages, removes the session from the network, and ends the thread.
  ~Publisher();
  Publisher(const Publisher&) = delete;
  Publisher& operator=(const Publisher&) = delete;

  void say(std::vector<Outgoing> messages);
  void offer(std::shared_ptr<const Snapshot> snapshot);
  /// Waits until all queued messages and snapshots have been sent.
  void flush();
  PublisherCounters counters() const;
  const SessionInfo& info() const { return info_; }

 private:
  Bus& bus_;
  SessionInfo info_;
  std::shared_ptr<const SceneContent> content_;
  std::map<BodyId, RigidSender> rigid_;
  std::map<BodyId, SoftSender> soft_;
  HandSender hands_;
  PanelSender panels_;
  bool newcomer_ = false;
  std::vector<FeltPlanes> felt_;                        // of the newest snapshot
  std::chrono::steady_clock::time_point felt_at_ = {};  // when felt_ was first sent

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
