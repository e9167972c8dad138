#include "server/session/journal/journal.h"

#include <fmt/format.h>

#include <utility>

#include "common/assert.h"
#include "common/error.h"

namespace prosector {
namespace {

std::uint64_t weight(const JournalTick& tick) {
  std::uint64_t states = 0;
  for (const CutEvent& e : tick.input.input.cuts) states += e.state ? e.state->size() : 0;
  return 128 + states + 128 * (tick.input.input.events.size() + tick.input.input.targets.size()) +
         1024 * tick.events.size();
}

}  // namespace

std::unique_ptr<Journal> Journal::create(const std::filesystem::path& file, const JournalHeader& header,
                                         const JournalLimits& limits) {
  if (std::filesystem::exists(file))
    throw InputError(fmt::format(
        "--journal {}: the file already exists; choose another file, or continue it with --resume",
        file.string()));
  try {
    std::unique_ptr<JournalFile> made = JournalFile::create(file, header, limits.file_bytes);
    return std::unique_ptr<Journal>(
        new Journal(file, std::make_unique<FileClaim>(file), std::move(made), limits));
  } catch (const SqliteError& e) {
    throw InputError(fmt::format("--journal {}: {}", file.string(), e.what()));
  }
}

std::unique_ptr<Journal> Journal::append_to(const std::filesystem::path& file, const JournalLimits& limits) {
  try {
    auto claim = std::make_unique<FileClaim>(file);
    return std::unique_ptr<Journal>(
        new Journal(file, std::move(claim), JournalFile::reopen(file, limits.file_bytes), limits));
  } catch (const SqliteError& e) {
    throw InputError(fmt::format("--resume {}: {}", file.string(), e.what()));
  }
}

Journal::Journal(std::filesystem::path path, std::unique_ptr<FileClaim> claim,
                 std::unique_ptr<JournalFile> file, const JournalLimits& limits)
    : path_(std::move(path)),
      limits_(limits),
      claim_(std::move(claim)),
      file_(std::move(file)),
      mover_(path_),
      thread_([this] { run(); }) {}

Journal::~Journal() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Journal::append(JournalTick tick, std::vector<std::uint8_t> checkpoint) {
  {
    const std::lock_guard lock(mutex_);
    if (!error_.empty()) return;
    queued_bytes_ += weight(tick) + checkpoint.size();
    if (queued_bytes_ > limits_.queue_bytes)
      return fail("the disk is too slow to write the journal", tick.tick);
    tick.rebuilt |= !checkpoint.empty();
    if (!checkpoint.empty()) checkpoints_.push_back({tick.tick, std::move(checkpoint), 0});
    PROSECTOR_ASSERT(queue_.empty() || queue_.back().tick < tick.tick);
    queue_.push_back(std::move(tick));
  }
  wake_.notify_one();
}

bool Journal::settle() {
  std::unique_lock lock(mutex_);
  const auto settled = [this] { return queue_.empty() && !writing_; };
  if (late_) late_ = !settled();
  if (!late_) late_ = !settled_.wait_for(lock, limits_.time_limit, settled);
  return !late_;
}

std::string Journal::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

void Journal::run() {
  std::unique_lock lock(mutex_);
  while (error_.empty()) {
    const auto busy = [this] {
      return !queue_.empty() || !checkpoints_.empty() || !under_way_.state.empty();
    };
    wake_.wait(lock, [&] { return stop_ || busy(); });
    if (!busy()) return;
    if (!queue_.empty())
      write_ticks(lock);
    else
      write_checkpoint_part(lock);
  }
}

void Journal::write_ticks(std::unique_lock<std::mutex>& lock) {
  PROSECTOR_ASSERT(!queue_.empty() && !writing_);
  const std::deque<JournalTick> batch = std::exchange(queue_, {});
  for (const JournalTick& tick : batch) queued_bytes_ -= weight(tick);
  writing_ = true;
  lock.unlock();
  std::string why;
  try {
    file_->write(batch);
  } catch (const SqliteError& e) {
    why = e.what();
  }
  lock.lock();
  writing_ = false;
  if (!why.empty()) fail(why, batch.front().tick);
  settled_.notify_all();
}

void Journal::write_checkpoint_part(std::unique_lock<std::mutex>& lock) {
  if (under_way_.state.empty()) {
    PROSECTOR_ASSERT(!checkpoints_.empty());
    under_way_ = std::move(checkpoints_.front());
    checkpoints_.pop_front();
  }
  lock.unlock();
  bool whole = false;
  std::string why;
  try {
    whole = file_->write_part(under_way_);
  } catch (const SqliteError& e) {
    why = e.what();
  }
  lock.lock();
  if (!why.empty()) return fail(why, under_way_.tick);
  if (!whole) return;
  queued_bytes_ -= under_way_.state.size();
  under_way_ = {};
}

void Journal::fail(const std::string& why, std::uint64_t tick) {
  error_ = fmt::format("journal stopped at tick {}: {}", tick, why);
  queue_.clear();
  checkpoints_.clear();
}

}  // namespace prosector
