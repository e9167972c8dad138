#include "server/session/run/tick_journal.h"

#include <fmt/format.h>

#include <bit>
#include <utility>

#include "common/error.h"

namespace prosector {
namespace {

constexpr std::int64_t longest_replay_ns = 1'000'000'000;  // longest replay when a session is resumed
constexpr const char* journal_is_late = "journal writing is behind the session: the disk is too slow";
constexpr double journal_interval = 60;  // s between two reports that the journal is late

}  // namespace

TickJournal::TickJournal(Simulation& simulation, Journal* journal, Hooks hooks)
    : simulation_(simulation), journal_(journal), hooks_(std::move(hooks)), lateness_(journal_interval) {}

TickJournal::State TickJournal::checkpoint_if_due() {
  const bool regular = simulation_.time().tick % checkpoint_ticks == 0;
  const bool long_ago = journal_ != nullptr && since_checkpoint_ns_ > longest_replay_ns;
  if (!regular && !long_ago) return {};
  since_checkpoint_ns_ = 0;
  return checkpoint();
}

TickJournal::State TickJournal::checkpoint() {
  try {
    return hooks_.checkpoint ? hooks_.checkpoint() : simulation_.checkpoint();
  } catch (const InputError& error) {
    if (std::has_single_bit(++refused_checkpoints_))  // at powers of two: must not flood the console
      hooks_.say(
          fmt::format("internal error: the checkpoint of tick {} cannot be restored and is skipped ({} so "
                      "far); the session continues: {}. Please report this.",
                      simulation_.time().tick, refused_checkpoints_, error.what()));
    return {};
  }
}

void TickJournal::append(JournalTick tick, State checkpoint) {
  if (journal_ == nullptr) return;
  tick.rebuilt = !checkpoint.empty();
  journal_->append(std::move(tick), std::move(checkpoint));
}

void TickJournal::settle(double now) {
  if (journal_ == nullptr || !error_.empty()) return;
  late_ = !journal_->settle();
  if (const auto late = lateness_.look(late_, now))
    hooks_.say(*late ? fmt::format("{}; the session continues", journal_is_late)
                     : "the journal has caught up with the session");
  error_ = journal_->error();
  if (!error_.empty()) hooks_.say(error_ + "; the session continues without a journal");
}

std::string TickJournal::complaint() const {
  std::string out = late_ ? journal_is_late : "";
  if (!error_.empty()) out += (out.empty() ? "" : "; ") + error_;
  return out;
}

}  // namespace prosector
