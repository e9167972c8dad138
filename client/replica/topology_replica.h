#pragma once
// Topology of one soft body on a client: shown revision and pending revisions. Only revisions verified by
// their hashes are shown; until then the surface stays unchanged.

#include <cstdint>
#include <map>
#include <optional>

#include "client/replica/asset_store.h"
#include "client/replica/soft_replica.h"
#include "common/body_messages.h"

namespace prosector {

class TopologyReplica {
 public:
  /// Adds a received topology revision (change of the mesh by a cut). Revisions may arrive in any order and
  /// repeatedly.
  void add(const TopologyRevision& revision);
  /// Applies the received topology revisions to the surface of `soft` as far as possible. Patches are applied
  /// in order; a keyframe (whole surface) bridges a gap or a patch that failed verification. Returns true if
  /// the surface changed.
  bool advance(const AssetStore& assets, SoftReplica& soft, std::int64_t now_ns);

  /// Returns the topology revision that is displayed, without its patch; null before the first.
  const TopologyRevision* shown() const { return shown_ ? &*shown_ : nullptr; }
  /// Returns whether to request a keyframe (whole surface) from the server now: a topology revision failed
  /// verification, or one has been missing for over 1 s. Returns true at most once a second.
  bool needs_keyframe(std::int64_t now_ns);
  std::uint64_t refused() const { return refused_; }

 private:
  std::optional<TopologyRevision> shown_;              // without its patch
  std::map<std::uint32_t, TopologyRevision> waiting_;  // later revisions
  std::optional<std::uint32_t> unverified_;            // revision whose patch failed verification
  bool failed_ = false;  // a verification failed, and no revision was shown since
  std::optional<std::int64_t> stuck_since_ns_, asked_ns_;
  std::uint64_t refused_ = 0;

  bool follow_next(SoftReplica& soft);
  bool enter_newest_keyframe(const AssetStore& assets, SoftReplica& soft);
  void show(std::map<std::uint32_t, TopologyRevision>::iterator revision);
};

}  // namespace prosector
