#pragma once
// The client's configuration while it is changed in the set-up window: what is in the file, what it would be,
// and both as a person reads them. Nothing is written before it was asked for.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "drivers/client_config.h"
#include "drivers/client_config_write.h"

namespace prosector {

/// A line that a draft changes. Either may be empty: it comes, or it goes.
struct ChangedLine {
  std::string before, after;
};

class ConfigDraft {
 public:
  /// Reads the file. One that is missing counts as empty; of one that can't be used, problem() tells why, and
  /// nothing is changed in it.
  explicit ConfigDraft(std::filesystem::path file);

  /// Changes keys. Returns why that isn't allowed; empty: it is done.
  std::string change(const std::vector<ConfigChange>& changes);
  /// Keeps a text for a file of that name beside the configuration's; it is written when the draft is.
  void put_beside(const std::string& name, std::string text);
  /// Writes the draft and what is beside it, with its comments and order kept. Throws InputError where that
  /// can't be, and where the file was written by others since it was read: that isn't written over.
  void save();
  /// Forgets what was not written, and reads the file anew.
  void revert();

  /// Returns a file that config() names as the text of the configuration does: beside it where it lies there.
  std::string named(const std::string& file) const;

  const ClientConfig& config() const { return config_; }
  const std::filesystem::path& file() const { return file_; }
  const std::string& problem() const { return problem_; }
  bool changed() const { return draft_ != saved_ || !beside_.empty(); }
  std::vector<ChangedLine> changes() const;

 private:
  std::filesystem::path file_;
  std::string saved_, draft_, problem_;
  std::map<std::string, std::string> beside_;  // texts by names of files
  ClientConfig config_;

  void read();
};

}  // namespace prosector
