#pragma once
// Publishes a session: its messages, and its snapshots, which have the server's status at 10 Hz. Live
// sessions and recordings use it alike.

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "server/session/sending/publisher.h"

namespace prosector {

class SnapshotFeed {
 public:
  /// Announces the session on the bus, which must outlive the feed.
  SnapshotFeed(Bus& bus, const SessionInfo& info, std::shared_ptr<const SceneContent> content)
      : publisher_(bus, info, std::move(content)) {}

  void say(std::vector<Outgoing> messages) { publisher_.say(std::move(messages)); }
  /// Returns whether the next snapshot should have the server's status, because at `now_ns` (nanoseconds on a
  /// monotonic clock) the period since the last one is over.
  bool status_due(std::int64_t now_ns) const;
  /// Publishes a snapshot without the server's status.
  void offer(std::shared_ptr<const Snapshot> snapshot);
  /// Publishes a snapshot at the time `now_ns` (nanoseconds on a monotonic clock). If the server's status is
  /// due, calls `status` and publishes its result with the snapshot.
  void offer(std::shared_ptr<Snapshot> snapshot, std::int64_t now_ns,
             const std::function<ServerStatus()>& status);
  /// Returns the snapshot that was published last. Null before the first one.
  const Snapshot* last() const { return last_.get(); }
  Publisher& publisher() { return publisher_; }
  const Publisher& publisher() const { return publisher_; }

 private:
  std::shared_ptr<const Snapshot> last_;
  std::int64_t status_ns_ = 0;  // time of the last status
  Publisher publisher_;
};

}  // namespace prosector
