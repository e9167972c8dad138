#pragma once
// The file of a journal that is written: its tables, batches of ticks, and checkpoints in parts.

#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "server/calibration/choose_scene.h"
#include "server/session/journal/journal_rows.h"
#include "server/session/journal/sqlite.h"

namespace prosector {

inline constexpr std::uint64_t journal_version = 16;
/// Keys of the journal's description (scene, session, choices and initial state), in the order in which the
/// description's seal (hash) covers them.
inline constexpr std::array journal_keys = {"format",  "scene_file", "scene_text", "session",  "content_hash",
                                            "choices", "identity",   "begins_at",  "beginning"};

struct JournalHeader {
  std::filesystem::path scene_file;  // absolute: files that the scene names are found relative to it
  std::string scene_text;
  std::string session;
  ContentHash content_hash{};                // of the compiled scene
  std::vector<Choice> choices;               // of bodies that were chosen by need: a replay uses these
  std::uint64_t begins_at = 0;               // tick of the state that it begins with
  std::vector<std::uint8_t> beginning = {};  // that state; empty: the scene's
};

/// A checkpoint of the simulation that is being written to the journal's file in parts.
struct WaitingCheckpoint {
  std::uint64_t tick = 0;
  std::vector<std::uint8_t> state;
  std::size_t parts = 0;  // parts that are in the file
};

class JournalFile {
 public:
  /// Creates a new journal file of at most `limit_bytes` bytes; 0: limited by the disk only. Throws
  /// SqliteError if that fails.
  static std::unique_ptr<JournalFile> create(const std::filesystem::path& file, const JournalHeader& header,
                                             std::uint64_t limit_bytes);
  /// Opens a journal file, which has been read to its last tick, to append further ticks. Its size is limited
  /// to `limit_bytes` bytes; 0: by the disk only. Throws SqliteError if that fails.
  static std::unique_ptr<JournalFile> reopen(const std::filesystem::path& file, std::uint64_t limit_bytes);
  /// Merges SQLite's write-ahead log into the journal's file and closes it.
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// Returns the number of starts and resumes of the session, the current one included: see
  /// common/server_run.h.
  std::uint32_t reign() const { return reign_; }

  /// Writes either all ticks of the batch or none, so that the predecessors of every tick in the file are in
  /// the file, too. Throws SqliteError if that fails.
  void write(const std::deque<JournalTick>& batch);
  /// Writes the next part of the checkpoint. Returns whether the checkpoint is now complete in the file.
  /// Parts are small, so that ticks don't wait until a large state is written. Throws SqliteError if that
  /// fails.
  bool write_part(WaitingCheckpoint& checkpoint);

 private:
  explicit JournalFile(std::unique_ptr<SqliteDatabase> database);

  std::unique_ptr<SqliteDatabase> database_;
  std::uint64_t seal_ = 0;
  std::uint32_t reign_ = 0;

  void begin_reign();
  void insert(const JournalTick& tick);
  void forget_old_checkpoints();
};

}  // namespace prosector
