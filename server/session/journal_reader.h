#pragma once
// A journal, read back.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "server/session/journal.h"

namespace prosector {

struct Checkpoint {
  std::uint64_t tick = 0;
  std::vector<std::uint8_t> state;
};

class JournalReader {
 public:
  /// Throws InputError when `file` is no journal that this version reads.
  explicit JournalReader(const std::filesystem::path& file);

  const JournalHeader& header() const { return header_; }
  const std::string& content_hash() const { return content_hash_; }  // hex, of the compiled scene
  std::uint64_t last_tick() const;                                   // 0: none
  std::optional<Checkpoint> last_checkpoint() const;
  bool has_checkpoint(std::uint64_t tick) const;
  /// What the step of `tick` changed of bodies' topology, in order; without patches, tick by tick.
  std::vector<TopologyRevision> topology(std::uint64_t tick) const;
  /// Calls `visit` for each tick after `after`, in order, until it returns false. Throws InputError where one
  /// is missing or damaged.
  void for_each_tick(std::uint64_t after, const std::function<bool(const JournalTick&)>& visit) const;

 private:
  std::filesystem::path file_;
  std::unique_ptr<SqliteDatabase> database_;
  JournalHeader header_;
  std::string content_hash_;

  std::string meta(const std::string& key) const;
  [[noreturn]] void refuse(const std::string& why) const;
};

}  // namespace prosector
