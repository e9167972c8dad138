#include "server/session/journal/replay.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/error.h"
#include "server/physics/base/record.h"

namespace prosector {

void require_same_scene(const JournalReader& journal, const Simulation& simulation) {
  if (to_hex(simulation.content_hash()) != journal.content_hash())
    throw InputError(fmt::format(
        "the compiled scene has the hash {}, but the journal recorded {}: a file referenced by {} has "
        "changed, or this is another build",
        to_hex(simulation.content_hash()), journal.content_hash(), journal.header().scene_file.string()));
}

bool same_topology(const std::vector<TopologyRevision>& recorded, const std::vector<TopologyChange>& made) {
  return std::ranges::equal(recorded, made, [](const TopologyRevision& a, const TopologyChange& b) {
    return a.body == b.body && a.revision == b.revision && a.cause == b.cause && a.author == b.author &&
           a.piece_of == (b.piece_of ? static_cast<std::int32_t>(*b.piece_of) : -1) &&
           a.content_hash == b.content_hash;
  });
}

namespace {

/// Returns the tick of the first checkpoint from `tick` on; `tick` where there is none.
std::uint64_t next_checkpoint(const JournalReader& journal, std::uint64_t tick) {
  std::uint64_t next = tick;
  for (const std::uint64_t at : journal.checkpoint_ticks())  // newest first
    if (at >= tick) next = at;
  return next;
}

std::optional<ReplayResult::Value> differing_value(const JournalReader& journal, const Simulation& simulation,
                                                   std::uint64_t tick) {
  const auto ticks = journal.checkpoint_ticks();
  if (std::ranges::find(ticks, tick) == ticks.end()) return std::nullopt;
  const std::optional<Checkpoint> checkpoint = journal.checkpoint(tick);
  if (!checkpoint) return std::nullopt;
  RecordLabels labels;
  const std::vector<std::uint8_t> own = simulation.save(&labels);
  const auto [at, recorded] = std::ranges::mismatch(own, checkpoint->state);
  if (at == own.end() && recorded == checkpoint->state.end()) return std::nullopt;
  return ReplayResult::Value{tick, labels.at(static_cast<std::size_t>(at - own.begin()))};
}

}  // namespace

ReplayResult replay(const JournalReader& journal, Simulation& simulation,
                    const std::function<void(std::uint64_t tick)>& progress) {
  require_same_scene(journal, simulation);
  ReplayResult result;
  result.last_hash = simulation.state_hash();
  std::uint64_t compared = 0;  // the tick whose checkpoint names the value that differs
  journal.for_each_tick(simulation.time().tick, [&](const JournalTick& tick) {
    const StepReport& report = simulation.step(tick.input.input);
    const bool same = same_topology(tick.topology, report.topology);
    if (tick.rebuilt) simulation.checkpoint();
    result.last_hash = simulation.state_hash();
    if (!result.first_difference && (result.last_hash != tick.state_hash || !same)) {
      result.first_difference = tick.tick;
      compared = next_checkpoint(journal, tick.tick);
    }
    if (result.first_difference) {
      if (tick.tick < compared) return true;
      result.differing_value = differing_value(journal, simulation, tick.tick);
      return false;
    }
    ++result.ticks;
    if (progress) progress(tick.tick);
    return true;
  });
  return result;
}

namespace {

/// Puts the newest checkpoint that is whole into the simulation; where there is none, the scene's beginning
/// stays.
void restore_newest(const JournalReader& journal, Simulation& simulation,
                    const std::function<void(const std::string&)>& say) {
  for (const std::uint64_t tick : journal.checkpoint_ticks()) {
    const std::optional<Checkpoint> checkpoint = journal.checkpoint(tick);
    if (!checkpoint) {
      say(fmt::format("the checkpoint of tick {} is damaged: using an earlier one", tick));
      continue;
    }
    simulation.restore(checkpoint->state);
    if (simulation.state_hash() != journal.state_hash(tick))
      throw InputError(
          fmt::format("the checkpoint of tick {} gives another state in this build: use the build that "
                      "recorded the journal",
                      tick));
    return;
  }
}

}  // namespace

ReplayResult resume(const JournalReader& journal, Simulation& simulation,
                    const std::function<void(const std::string&)>& say) {
  require_same_scene(journal, simulation);
  restore_newest(journal, simulation, say);
  return replay(journal, simulation, {});
}

}  // namespace prosector
