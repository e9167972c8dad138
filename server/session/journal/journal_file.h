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

inline constexpr std::uint64_t journal_version = 15;
/// Keys of the file's description, in the order in which they are hashed.
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

/// A checkpoint that is being written to the file.
struct WaitingCheckpoint {
  std::uint64_t tick = 0;
  std::vector<std::uint8_t> state;
  std::size_t parts = 0;  // parts that are in the file
};

class JournalFile {
 public:
  /// Creates a new file of at most `limit_bytes`; 0: no limit but the disk. Throws SqliteError.
  static std::unique_ptr<JournalFile> create(const std::filesystem::path& file, const JournalHeader& header,
                                             std::uint64_t limit_bytes);
  /// Opens a file that has been read to its end. Throws SqliteError.
  static std::unique_ptr<JournalFile> reopen(const std::filesystem::path& file, std::uint64_t limit_bytes);
  /// Merges the write-ahead log into the file.
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// Returns how often the session was started or resumed: see common/server_run.h.
  std::uint32_t reign() const { return reign_; }

  /// Writes all ticks of the batch or none: the predecessors of every tick in the file are in it, too. Throws
  /// SqliteError.
  void write(const std::deque<JournalTick>& batch);
  /// Writes one more part; returns true when the checkpoint is complete in the file. Parts are small, so that
  /// ticks don't wait for a large state. Throws SqliteError.
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
