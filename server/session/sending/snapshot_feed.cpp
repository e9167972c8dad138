#include "server/session/sending/snapshot_feed.h"

#include <utility>

namespace prosector {
namespace {

constexpr std::int64_t status_period_ns = 100'000'000;  // between two ServerStatus messages

}  // namespace

bool SnapshotFeed::status_due(std::int64_t now_ns) const {
  return now_ns - status_ns_ >= status_period_ns;
}

void SnapshotFeed::offer(std::shared_ptr<const Snapshot> snapshot) {
  publisher_.offer(snapshot);
  last_ = std::move(snapshot);
}

void SnapshotFeed::offer(std::shared_ptr<Snapshot> snapshot, std::int64_t now_ns,
                         const std::function<ServerStatus()>& status) {
  if (status_due(now_ns)) {
    snapshot->status = status();
    status_ns_ = now_ns;
  }
  offer(std::move(snapshot));
}

}  // namespace prosector
