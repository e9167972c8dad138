#pragma once
// The journal of a session: one SQLite file from which the run can be repeated bit for bit, or gone on with.
//
// It keeps the scene's text, every tick's inputs as consumed and its state hash, and checkpoints. A thread of
// its own writes in batches; the step only queues. What the disk refuses never ends a session: journalling
// stops, and says so.

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "common/hash.h"
#include "server/calibration/choose_scene.h"
#include "server/session/session.h"
#include "server/session/sqlite.h"

namespace prosector {

inline constexpr std::uint64_t journal_version = 9;

struct JournalHeader {
  std::filesystem::path scene_file;  // absolute: what the scene names is found beside it
  std::string scene_text;
  std::string session;
  ContentHash content_hash{};   // of the compiled scene
  std::vector<Choice> choices;  // of bodies that were chosen by need: a replay takes them from here
};

struct JournalTick {
  std::uint64_t tick = 0;
  ConsumedInput input;
  std::uint64_t state_hash = 0;          // after the step
  std::vector<std::uint8_t> checkpoint;  // empty: none at this tick
  std::vector<SessionEvent> events;
  std::vector<TopologyRevision> topology;  // that the step made; without patches
};

struct JournalLimits {
  std::uint64_t file_bytes = 0;                  // 0: as much as the disk holds
  std::uint64_t queue_bytes = 64 * 1024 * 1024;  // a disk slower than this backlog stops the journal
};

class Journal {
 public:
  /// Starts a new file. Throws InputError when there is one already or none can be made.
  static std::unique_ptr<Journal> create(const std::filesystem::path& file, const JournalHeader& header,
                                         const JournalLimits& limits);
  /// Goes on with a file that has been read to its end.
  static std::unique_ptr<Journal> append_to(const std::filesystem::path& file, const JournalLimits& limits);
  /// Writes what is queued.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  void append(JournalTick tick);
  /// Empty while all is well; else why journalling stopped, and at which tick.
  std::string trouble() const;
  const std::filesystem::path& file() const { return file_; }

 private:
  Journal(std::filesystem::path file, std::unique_ptr<SqliteDatabase> database, const JournalLimits& limits);

  std::filesystem::path file_;
  JournalLimits limits_;
  std::unique_ptr<SqliteDatabase> database_;

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<JournalTick> queue_;
  std::uint64_t queued_bytes_ = 0;
  std::string trouble_;
  bool stop_ = false;
  std::thread thread_;

  void run();
  void write(const std::deque<JournalTick>& batch);
  void fail(const std::string& why, std::uint64_t tick);
};

}  // namespace prosector
