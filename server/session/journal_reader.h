#pragma once
// A journal, read back: from any place that can be read, and no row is believed whose seal does not fit.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/session/journal_file.h"

namespace prosector {

struct Checkpoint {
  std::uint64_t tick = 0;
  std::vector<std::uint8_t> state;
};

class JournalReader {
 public:
  /// Opens `file` to read. Throws InputError when it is no journal that this version reads, or damaged.
  explicit JournalReader(const std::filesystem::path& file);

  const JournalHeader& header() const { return header_; }
  const std::string& content_hash() const { return content_hash_; }  // hex, of the compiled scene
  std::uint64_t last_tick() const;                                   // 0: none
  /// Returns what was read around, for people; empty when all is well.
  const std::string& trouble() const { return trouble_; }
  /// Returns the ticks of checkpoints, newest first; what they hold is proven by checkpoint().
  std::vector<std::uint64_t> checkpoint_ticks() const;
  /// Returns the checkpoint; nothing when it is damaged.
  std::optional<Checkpoint> checkpoint(std::uint64_t tick) const;
  /// Returns the state hash of a tick. Throws InputError when it is missing or damaged.
  std::uint64_t state_hash(std::uint64_t tick) const;
  /// Returns a tick. Throws InputError when it is missing or damaged.
  JournalTick tick(std::uint64_t tick) const;
  /// Calls `visit` for each tick after `after`, in order, until it returns false. Throws InputError where one
  /// is missing or damaged.
  void for_each_tick(std::uint64_t after, const std::function<bool(const JournalTick&)>& visit) const;
  /// Writes all of it to a new file, without a log beside it. Throws InputError when that can't be written.
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
