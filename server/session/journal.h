#pragma once
// The journal of a session: one SQLite file from which the run can be repeated bit for bit, or gone on with.
//
// It keeps the scene's text, every tick's inputs as consumed and its state hash, and checkpoints, each under
// a seal. A thread of its own writes each tick at once. The loop waits for that, for a bounded time, before
// it shows the tick to anybody: what people saw survives the death of the server. What the disk refuses never
// ends a session: journalling stops, and says so.

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

#include "server/session/file_claim.h"
#include "server/session/journal_file.h"
#include "server/session/wal_mover.h"

namespace prosector {

struct JournalLimits {
  std::uint64_t file_bytes = 0;                  // 0: as much as the disk holds
  std::uint64_t queue_bytes = 64 * 1024 * 1024;  // a disk slower than this backlog stops the journal
  std::chrono::milliseconds patience{25};        // how long a tick waits for the disk
};

class Journal {
 public:
  /// Starts a new file. Throws InputError when there is one already or none can be made.
  static std::unique_ptr<Journal> create(const std::filesystem::path& file, const JournalHeader& header,
                                         const JournalLimits& limits);
  /// Goes on with a file that has been read to its end. Throws InputError when another server writes it.
  static std::unique_ptr<Journal> append_to(const std::filesystem::path& file, const JournalLimits& limits);
  /// Writes what is queued, and leaves one file without a log beside it.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Appends a tick. `checkpoint` is the state at the tick's end; empty: none.
  void append(JournalTick tick, std::vector<std::uint8_t> checkpoint = {});
  /// Waits until all that was appended is in the file, for `patience` at most. After a wait in vain nobody
  /// waits until the disk has caught up. Returns false while it has not.
  bool settle();
  /// Returns why journalling stopped, and at which tick; empty while all is well.
  std::string trouble() const;
  const std::filesystem::path& file() const { return path_; }
  std::uint32_t reign() const { return file_->reign(); }

 private:
  Journal(std::filesystem::path path, std::unique_ptr<FileClaim> claim, std::unique_ptr<JournalFile> file,
          const JournalLimits& limits);

  std::filesystem::path path_;
  JournalLimits limits_;
  std::unique_ptr<FileClaim> claim_;  // outlives the file: to let go of it ends SQLite's locks
  std::unique_ptr<JournalFile> file_;
  WalMover mover_;

  mutable std::mutex mutex_;
  std::condition_variable wake_, settled_;
  std::deque<JournalTick> queue_;
  std::deque<WaitingCheckpoint> checkpoints_;  // behind the ticks
  std::uint64_t queued_bytes_ = 0;
  bool writing_ = false;  // ticks that left the queue and aren't in the file
  bool late_ = false;     // a wait was in vain, and the queue has not been empty since
  std::string trouble_;
  bool stop_ = false;
  WaitingCheckpoint under_way_;  // the thread's own; an empty state: none
  std::thread thread_;

  void run();
  void write_ticks(std::unique_lock<std::mutex>& lock);
  void write_checkpoint_part(std::unique_lock<std::mutex>& lock);
  void fail(const std::string& why, std::uint64_t tick);
};

}  // namespace prosector
