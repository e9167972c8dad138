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
  /// Opens the journal `file` for reading. Throws InputError if it is not a journal of this version, or is
  /// damaged.
  explicit JournalReader(const std::filesystem::path& file);

  const JournalHeader& header() const { return header_; }
  const std::string& content_hash() const { return content_hash_; }  // hex, of the compiled scene
  std::uint64_t last_tick() const;                                   // 0: none
  /// Returns a message about missing or damaged data of the journal that was skipped. Empty if there was
  /// none.
  const std::string& error() const { return error_; }
  /// Returns the ticks of the journal's checkpoints, newest first. Their data may be damaged; checkpoint()
  /// verifies it.
  std::vector<std::uint64_t> checkpoint_ticks() const;
  /// Returns the checkpoint of that tick. Returns nothing if it is missing or damaged.
  std::optional<Checkpoint> checkpoint(std::uint64_t tick) const;
  /// Returns the recorded hash of the simulation's state after a tick. Throws InputError if the tick is
  /// missing or damaged.
  std::uint64_t state_hash(std::uint64_t tick) const;
  /// Returns the recorded inputs, events and topology changes of a tick. Throws InputError if the tick is
  /// missing or damaged.
  JournalTick tick(std::uint64_t tick) const;
  /// Calls `visit` for each recorded tick after tick `after`, in order, until `visit` returns false. Throws
  /// InputError if a tick is missing or damaged.
  void for_each_tick(std::uint64_t after, const std::function<bool(const JournalTick&)>& visit) const;
  /// Writes the whole journal to a new file that needs no separate write-ahead log. Throws InputError if the
  /// file can't be written.
  void export_to(const std::filesystem::path& file) const;

 private:
  std::filesystem::path file_;
  std::unique_ptr<SqliteDatabase> database_;
  JournalHeader header_;
  std::string content_hash_, error_;
  std::uint64_t seal_ = 0;

  void read_description();
  std::string meta(const std::string& key) const;
  std::vector<TopologyRevision> topology(std::uint64_t tick) const;
  std::vector<SessionEvent> events(std::uint64_t tick) const;
  [[noreturn]] void refuse(const std::string& why) const;
};

}  // namespace prosector
