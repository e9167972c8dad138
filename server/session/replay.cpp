#include "server/session/replay.h"

#include <fmt/format.h>

#include "common/error.h"

namespace prosector {

void require_same_scene(const JournalReader& journal, const Simulation& simulation) {
  if (to_hex(simulation.content_hash()) != journal.content_hash())
    throw InputError(fmt::format(
        "the scene compiles to {}, the journal recorded {}: a file that {} names has changed, or this is "
        "another build",
        to_hex(simulation.content_hash()), journal.content_hash(), journal.header().scene_file.string()));
}

ReplayResult replay(const JournalReader& journal, Simulation& simulation,
                    const std::function<void(std::uint64_t tick)>& progress) {
  require_same_scene(journal, simulation);
  ReplayResult result;
  result.last_hash = simulation.state_hash();
  journal.for_each_tick(simulation.time().tick, [&](const JournalTick& tick) {
    simulation.step(tick.input.input);
    // The recorded run rebuilt its caches here.
    if (journal.has_checkpoint(tick.tick)) simulation.checkpoint();
    result.last_hash = simulation.state_hash();
    if (result.last_hash != tick.state_hash) {
      result.first_difference = tick.tick;
      return false;
    }
    ++result.ticks;
    if (progress) progress(tick.tick);
    return true;
  });
  return result;
}

ReplayResult resume(const JournalReader& journal, Simulation& simulation) {
  require_same_scene(journal, simulation);
  if (const auto checkpoint = journal.last_checkpoint()) simulation.restore(checkpoint->state);
  return replay(journal, simulation, {});
}

}  // namespace prosector
