#include "server/session/recording/recording_player.h"

#include <algorithm>
#include <utility>

#include "server/session/journal/replay.h"

namespace prosector {

RecordingPlayer::RecordingPlayer(const JournalReader& journal, Simulation& simulation)
    : journal_(journal), simulation_(simulation), last_tick_(journal.last_tick()) {
  require_same_scene(journal, simulation);
  for (const std::uint64_t tick : journal.checkpoint_ticks()) checkpoints_.insert(tick);
  beginning_ = simulation.save();
}

const StepReport& RecordingPlayer::step() {
  const JournalTick recorded = journal_.tick(tick() + 1);
  const StepReport& report = simulation_.step(recorded.input.input);
  if (near_enough_) {
    if (!meet_known_state() && recorded.rebuilt) (void)simulation_.checkpoint();
    return report;
  }
  State state;
  if (recorded.rebuilt) state = simulation_.checkpoint();
  if (!same_topology(recorded.topology, report.topology) || simulation_.state_hash() != recorded.state_hash)
    difference_ = recorded.tick;
  else if (recorded.rebuilt)
    keep(std::move(state));
  return report;
}

void RecordingPlayer::approach(std::uint64_t tick) {
  State state = state_before(std::min(tick, last_tick_));
  if (state.empty()) return;
  simulation_.restore(state);
  difference_.reset();
  near_enough_ = this->tick() == 0;
  if (this->tick() > journal_.header().begins_at &&
      simulation_.state_hash() != journal_.state_hash(this->tick()))
    difference_ = this->tick();
}

/// Restores the recorded state of this tick, if it is known: from here on playback is exact again.
bool RecordingPlayer::meet_known_state() {
  const auto kept = kept_.find(tick());
  std::optional<Checkpoint> checkpoint;
  if (kept == kept_.end() && checkpoints_.contains(tick())) checkpoint = journal_.checkpoint(tick());
  if (kept == kept_.end() && !checkpoint) return false;
  simulation_.restore(kept != kept_.end() ? kept->second : checkpoint->state);
  near_enough_ = false;
  return true;
}

/// Returns the known state from which the fewest ticks remain to be run; empty: the present one.
RecordingPlayer::State RecordingPlayer::state_before(std::uint64_t tick) {
  const bool can_go_on = this->tick() <= tick && !differs();
  const auto before = [&](std::uint64_t known) {
    return known <= tick && !(can_go_on && known <= this->tick());
  };
  const auto kept = kept_.upper_bound(tick);
  const std::uint64_t nearest_kept = kept == kept_.begin() ? 0 : std::prev(kept)->first;
  for (auto at = checkpoints_.upper_bound(tick); at != checkpoints_.begin();) {
    --at;
    if (*at <= nearest_kept || !before(*at)) break;
    if (std::optional<Checkpoint> checkpoint = journal_.checkpoint(*at)) return std::move(checkpoint->state);
  }
  if (nearest_kept > 0 && before(nearest_kept)) return kept_.at(nearest_kept);
  return can_go_on ? State() : beginning_;
}

/// Stores the present state. Beyond the memory budget, every second stored state is dropped.
void RecordingPlayer::keep(State state) {
  const auto [at, is_new] = kept_.try_emplace(tick(), std::move(state));
  if (!is_new) return;
  kept_bytes_ += at->second.size();
  if (kept_bytes_ <= kept_budget) return;
  bool drop = false;
  std::erase_if(kept_, [&](const auto& entry) {
    drop = !drop;
    if (drop) kept_bytes_ -= entry.second.size();
    return drop;
  });
}

}  // namespace prosector
