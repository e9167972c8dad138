#pragma once
// Reads a journal, also from media that can't be written. No row is used if its seal does not match.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/session/journal/journal_file.h"

namespace prosector {

struct Checkpoint {
  std::uint64_t tick = 0;
  std::vector<std::uint8_t> state;
};

class JournalReader {
 public:
  /// Opens `file` for reading. Throws InputError when it is not a journal of this version, or is damaged.
  explicit JournalReader(const std::filesystem::path& file);

  const JournalHeader& header() const { return header_; }
  const std::string& content_hash() const { return content_hash_; }  // hex, of the compiled scene
  std::uint64_t last_tick() const;                                   // 0: none
  /// Returns a message about missing or damaged data that was skipped; empty: none.
  const std::string& trouble() const { return trouble_; }
  /// Returns the ticks of checkpoints, newest first. checkpoint() verifies their data.
  std::vector<std::uint64_t> checkpoint_ticks() const;
  /// Returns the checkpoint; nothing when it is damaged.
  std::optional<Checkpoint> checkpoint(std::uint64_t tick) const;
  /// Returns the state hash of a tick. Throws InputError when it is missing or damaged.
  std::uint64_t state_hash(std::uint64_t tick) const;
  /// Returns a tick. Throws InputError when it is missing or damaged.
  JournalTick tick(std::uint64_t tick) const;
  /// Calls `visit` for each tick after `after`, in order, until it returns false. Throws InputError where a
  /// tick is missing or damaged.
  void for_each_tick(std::uint64_t after, const std::function<bool(const JournalTick&)>& visit) const;
  /// Writes the whole journal to a new file, without a write-ahead log. Throws InputError when that can't be
  /// written.
  void export_to(const std::filesystem::path& file) const;

 private:
  std::filesystem::path file_;
  std::unique_ptr<SqliteDatabase> database_;
  JournalHeader header_;
  std::string content_hash_, trouble_;
  std::uint64_t seal_ = 0;

  void read_description();
  std::string meta(const std::string& key) const;
  std::vector<TopologyRevision> topology(std::uint64_t tick) const;
  std::vector<SessionEvent> events(std::uint64_t tick) const;
  [[noreturn]] void refuse(const std::string& why) const;
};

}  // namespace prosector
