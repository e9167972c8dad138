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

/// Line of the configuration file that the unsaved changes affect. An empty `before` means that the line is
/// added, an empty `after` that it is removed.
struct ChangedLine {
  std::string before, after;
};

class ConfigDraft {
 public:
  /// Reads the configuration file. A missing file counts as empty. If it is invalid, problem() returns the
  /// reason, and change() refuses changes.
  explicit ConfigDraft(std::filesystem::path file);

  /// Changes keys of the draft, not of the file. If the changes are invalid, changes nothing and returns the
  /// reason; returns an empty string on success.
  std::string change(const std::vector<ConfigChange>& changes);
  /// Adds a file, for instance a calibration, that save() will write with this name and text into the
  /// configuration file's folder.
  void add_companion_file(const std::string& name, std::string text);
  /// Writes the draft to the configuration file, preserving its comments and order, and writes the files of
  /// add_companion_file(). Throws InputError if writing fails, or if another program changed the
  /// configuration file since it was read; that file is then not overwritten.
  void save();
  /// Discards the unsaved changes, and reads the configuration file again.
  void revert();

  /// Returns a path from config() as it is written in the configuration file: relative if it is in that
  /// file's folder or below it, otherwise unchanged.
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
