#pragma once
// How far a client has followed the topology of one soft body, and what it waits for. Only what proves right
// by its hashes is shown; until then the surface stays as it was.

#include <cstdint>
#include <map>
#include <optional>

#include "client/replica/asset_store.h"
#include "client/replica/soft_replica.h"
#include "common/messages.h"

namespace prosector {

class TopologyReplica {
 public:
  /// Takes a revision; they may come in any order, and again.
  void add(const TopologyRevision& revision);
  /// Takes `soft` on as far as what has arrived goes: by patches in order, by a keyframe over a gap or over a
  /// patch that did not prove right. Returns true when its surface changed.
  bool advance(const AssetStore& assets, SoftReplica& soft, std::int64_t now_ns);

  /// Returns the revision shown now; null before the first.
  const TopologyRevision* shown() const { return shown_ ? &*shown_ : nullptr; }
  /// Tells whether the server has to be asked for a keyframe: something did not prove right, or is long
  /// missing. True at most once a second.
  bool asks_keyframe(std::int64_t now_ns);
  std::uint64_t refused() const { return refused_; }

 private:
  std::optional<TopologyRevision> shown_;              // without its patch
  std::map<std::uint32_t, TopologyRevision> waiting_;  // later ones
  std::optional<std::uint32_t> unproven_;              // revision whose patch does not prove right
  bool failed_ = false;                                // something did not, and nothing was shown since
  std::optional<std::int64_t> stuck_since_ns_, asked_ns_;
  std::uint64_t refused_ = 0;

  bool follow_next(SoftReplica& soft);
  bool enter_newest_keyframe(const AssetStore& assets, SoftReplica& soft);
  void show(std::map<std::uint32_t, TopologyRevision>::iterator revision);
};

}  // namespace prosector
