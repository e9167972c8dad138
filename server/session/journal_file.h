#pragma once
// A journal's file as it is written: its tables, a batch of ticks at once, a checkpoint piece by piece.

#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "server/calibration/choose_scene.h"
#include "server/session/journal_rows.h"
#include "server/session/sqlite.h"

namespace prosector {

inline constexpr std::uint64_t journal_version = 14;
/// Keys of the file's description, as they are sealed.
inline constexpr std::array journal_keys = {"format",  "scene_file", "scene_text", "session",  "content_hash",
                                            "choices", "identity",   "begins_at",  "beginning"};

struct JournalHeader {
  std::filesystem::path scene_file;  // absolute: what the scene names is found beside it
  std::string scene_text;
  std::string session;
  ContentHash content_hash{};   // of the compiled scene
  std::vector<Choice> choices;  // of bodies that were chosen by need: a replay takes them from here
  std::uint64_t begins_at = 0;  // tick of the state that it begins with
  std::vector<std::uint8_t> beginning = {};  // that state; empty: the scene's
};

/// A state that is on its way into the file.
struct WaitingCheckpoint {
  std::uint64_t tick = 0;
  std::vector<std::uint8_t> state;
  std::size_t parts = 0;  // that are in the file
};

class JournalFile {
 public:
  /// Makes a new file, at most so large; 0: as large as the disk allows. Throws SqliteError.
  static std::unique_ptr<JournalFile> create(const std::filesystem::path& file, const JournalHeader& header,
                                             std::uint64_t limit_bytes);
  /// Opens one that has been read to its end. Throws SqliteError.
  static std::unique_ptr<JournalFile> reopen(const std::filesystem::path& file, std::uint64_t limit_bytes);
  /// Folds everything into one file.
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// Returns how often the session was begun or gone on with: common/server_run.h.
  std::uint32_t reign() const { return reign_; }

  /// Writes all of them or none: a file ends at a tick whose predecessors are all there. Throws SqliteError.
  void write(const std::deque<JournalTick>& batch);
  /// Writes one more part; returns true when the checkpoint is whole in the file. Parts are small, so that
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
