#include "client/replica/topology_replica.h"

#include <algorithm>
#include <iterator>

#include "common/assert.h"
#include "common/error.h"
#include "common/surface_patch.h"

namespace prosector {
namespace {

constexpr std::size_t max_waiting = 256;  // revisions; the oldest are dropped, a keyframe replaces them
constexpr std::int64_t gap_timeout_ns = 1'000'000'000;   // maximum duration of a gap
constexpr std::int64_t ask_interval_ns = 1'000'000'000;  // between two requests

}  // namespace

void TopologyReplica::add(const TopologyRevision& revision) {
  if (shown_ && revision.revision <= shown_->revision) {
    // In answer to a keyframe request the server sent the displayed revision: nothing is missing.
    if (revision.keyframe() && revision.chain_hash == shown_->chain_hash) failed_ = false;
    return;
  }
  if (chain_hash_of(revision) != revision.chain_hash) {
    ++refused_;
    failed_ = true;
    return;
  }
  waiting_[revision.revision] = revision;
  if (unverified_ == revision.revision) unverified_.reset();
  while (waiting_.size() > max_waiting) waiting_.erase(waiting_.begin());
}

bool TopologyReplica::advance(const AssetStore& assets, SoftReplica& soft, std::int64_t now_ns) {
  bool changed = false;
  while (follow_next(soft) || enter_newest_keyframe(assets, soft)) {
    changed = true;
    failed_ = false;
    stuck_since_ns_.reset();
  }
  if (waiting_.empty() && !failed_)
    stuck_since_ns_.reset();
  else if (!stuck_since_ns_)
    stuck_since_ns_ = now_ns;
  return changed;
}

/// Applies the patch of the revision after the displayed one.
bool TopologyReplica::follow_next(SoftReplica& soft) {
  if (!shown_ || waiting_.empty() || waiting_.begin()->first != shown_->revision + 1) return false;
  const auto next = waiting_.begin();
  const TopologyRevision& revision = next->second;
  if (unverified_ == revision.revision) return false;
  try {
    if (revision.previous_hash != shown_->chain_hash) throw InputError("topology: another predecessor");
    DrawnSurface surface = soft.drawn();
    apply(revision.patch, surface);
    if (hash(surface) != revision.surface_hash) throw InputError("topology: another surface");
    soft.follow(std::move(surface), revision.patch, revision.revision, revision.time);
  } catch (const InputError&) {
    ++refused_;
    failed_ = true;
    unverified_ = revision.revision;
    return false;
  }
  show(next);
  return true;
}

/// Switches to the newest keyframe. The first revision is often that of the scene, whose surface `soft`
/// already has.
bool TopologyReplica::enter_newest_keyframe(const AssetStore& assets, SoftReplica& soft) {
  const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                 [](const auto& entry) { return entry.second.keyframe(); });
  if (last == waiting_.rend()) return false;
  const auto at = std::prev(last.base());
  const TopologyRevision& revision = at->second;
  if (!shown_ && hash(soft.drawn()) == revision.surface_hash) {
    soft.begin_at(revision.revision);
    show(at);
    return true;
  }
  const auto mesh = assets.find(revision.mesh), map = assets.find(revision.map);
  if (!mesh || !map) return false;
  try {
    DrawnSurface surface{decode_triangle_mesh(*mesh), decode_streamed_surface(*map)};
    if (surface.rest.positions.size() != surface.streamed.map.rows.size() ||
        hash(surface) != revision.surface_hash)
      throw InputError(
          "topology keyframe of the server is invalid: it does not match the surface of its revision");
    soft.enter(std::move(surface), revision.revision, revision.time);
  } catch (const InputError&) {
    ++refused_;
    failed_ = true;
    waiting_.erase(at);
    return false;
  }
  show(at);
  return true;
}

void TopologyReplica::show(std::map<std::uint32_t, TopologyRevision>::iterator revision) {
  PROSECTOR_ASSERT(revision != waiting_.end() && (!shown_ || shown_->revision < revision->first));
  shown_ = std::move(revision->second);
  shown_->patch = {};
  waiting_.erase(waiting_.begin(), std::next(revision));
}

bool TopologyReplica::needs_keyframe(std::int64_t now_ns) {
  const bool stuck = stuck_since_ns_ && now_ns - *stuck_since_ns_ > gap_timeout_ns;
  if (!failed_ && !stuck) return false;
  if (asked_ns_ && now_ns - *asked_ns_ < ask_interval_ns) return false;
  asked_ns_ = now_ns;
  return true;
}

}  // namespace prosector
