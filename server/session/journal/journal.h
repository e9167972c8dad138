#pragma once
// The journal of a session: one SQLite file from which the run can be replayed bit for bit, or resumed.
//
// It stores the scene's text, every tick's inputs and state hash, and checkpoints. Each row has a seal, a
// hash over its data. A separate thread writes each tick immediately. The loop waits for that, for a bounded
// time, before it publishes the tick: what users saw survives a crash of the server. A failure of the disk
// never ends a session: journalling stops, and reports why.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "server/session/journal/file_claim.h"
#include "server/session/journal/journal_file.h"
#include "server/session/journal/wal_mover.h"

namespace prosector {

struct JournalLimits {
  std::uint64_t file_bytes = 0;                  // 0: no limit but the disk
  std::uint64_t queue_bytes = 64 * 1024 * 1024;  // a larger backlog for a slow disk stops the journal
  std::chrono::milliseconds time_limit{25};      // longest wait of a tick for the disk
};

class Journal {
 public:
  /// Creates a new journal file. Throws InputError if it exists already or can't be created.
  static std::unique_ptr<Journal> create(const std::filesystem::path& file, const JournalHeader& header,
                                         const JournalLimits& limits);
  /// Opens an existing journal, which has been read to its last tick, to append further ticks. Throws
  /// InputError if another server writes it.
  static std::unique_ptr<Journal> append_to(const std::filesystem::path& file, const JournalLimits& limits);
  /// Writes the queued ticks to the file, and merges SQLite's write-ahead log into it.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Queues a tick to be written to the journal. `checkpoint` is the simulation's state at the end of the
  /// tick; empty: no checkpoint.
  void append(JournalTick tick, std::vector<std::uint8_t> checkpoint = {});
  /// Waits until all appended ticks are in the file, for JournalLimits::time_limit at most. Returns false if
  /// they are not. After a timeout, calls return false without waiting until the disk has caught up.
  bool settle();
  /// Returns why writing of the journal stopped, and at which tick. Empty while the journal works.
  std::string error() const;
  const std::filesystem::path& file() const { return path_; }
  std::uint32_t reign() const { return file_->reign(); }

 private:
  Journal(std::filesystem::path path, std::unique_ptr<FileClaim> claim, std::unique_ptr<JournalFile> file,
          const JournalLimits& limits);

  std::filesystem::path path_;
  JournalLimits limits_;
  std::unique_ptr<FileClaim> claim_;  // outlives the file: closing it earlier would release SQLite's locks
  std::unique_ptr<JournalFile> file_;
  WalMover mover_;

  mutable std::mutex mutex_;
  std::condition_variable wake_, settled_;
  std::deque<JournalTick> queue_;
  std::deque<WaitingCheckpoint> checkpoints_;  // written when no ticks are queued
  std::uint64_t queued_bytes_ = 0;
  bool writing_ = false;  // ticks were taken from the queue and are not in the file yet
  bool late_ = false;     // a wait timed out, and the queue has not been empty since
  std::string error_;
  bool stop_ = false;
  WaitingCheckpoint under_way_;  // used by the thread only; an empty state: none
  std::thread thread_;

  void run();
  void write_ticks(std::unique_lock<std::mutex>& lock);
  void write_checkpoint_part(std::unique_lock<std::mutex>& lock);
  void fail(const std::string& why, std::uint64_t tick);
};

}  // namespace prosector
