#pragma once
// The client's configuration while it is edited in the set-up window: the saved text, the draft, and the
// parsed draft. Files are written only by save().

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "drivers/config/client_config.h"
#include "drivers/config/client_config_write.h"

namespace prosector {

/// A line that a draft changes. `before` empty: added; `after` empty: removed.
struct ChangedLine {
  std::string before, after;
};

class ConfigDraft {
 public:
  /// Reads the file. A missing file counts as empty. If it is invalid, problem() returns the reason, and
  /// changes are refused.
  explicit ConfigDraft(std::filesystem::path file);

  /// Changes keys. Returns the reason if the changes are invalid; empty: success.
  std::string change(const std::vector<ConfigChange>& changes);
  /// Stores the text of a file with this name next to the configuration file; save() writes it.
  void add_companion_file(const std::string& name, std::string text);
  /// Writes the draft and the files next to it, preserving comments and order. Throws InputError if writing
  /// fails, or if another program changed the file since it was read; the file is then not overwritten.
  void save();
  /// Discards unsaved changes, and reloads the file.
  void revert();

  /// Returns a file of config() as written in the configuration: relative if it is next to the configuration
  /// file.
  std::string named(const std::string& file) const;

  const ClientConfig& config() const { return config_; }
  const std::filesystem::path& file() const { return file_; }
  const std::string& problem() const { return problem_; }
  bool changed() const { return draft_ != saved_ || !beside_.empty(); }
  std::vector<ChangedLine> changes() const;

 private:
  std::filesystem::path file_;
  std::string saved_, draft_, problem_;
  std::map<std::string, std::string> beside_;  // texts by file name
  ClientConfig config_;

  void read();
};

}  // namespace prosector
