#pragma once
// The configuration's file while a client runs: what is written into it holds at once.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "drivers/client_config.h"

namespace prosector {

/// Where a configuration comes from: a file, and addresses of a command line, which come before the file's.
struct ConfigSource {
  std::filesystem::path file;  // empty: none
  std::string tracker, left_glove, right_glove, arm;
  std::shared_ptr<SharedCamera> camera = {};  // that the display sees by, and trackers, too; null: none

  /// Reads it. Throws InputError for a file or an address that isn't allowed.
  ClientConfig read() const;
};

class ConfigWatch {
 public:
  explicit ConfigWatch(ConfigSource source);

  /// Returns the configuration when its file was written since the last look, at most twice a second. What
  /// can't be used is said through `report`, and returns none.
  std::optional<ClientConfig> look(std::int64_t now_ns,
                                   const std::function<void(const std::string&)>& report);

 private:
  ConfigSource source_;
  std::filesystem::file_time_type written_{};
  std::int64_t looked_ns_ = 0;

  std::filesystem::file_time_type last_written() const;
};

}  // namespace prosector
