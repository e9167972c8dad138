#pragma once
// Watches the configuration file while a client runs; changes take effect immediately.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "drivers/config/client_config.h"

namespace prosector {

/// Source of a configuration: a file, and addresses from the command line, which override those in the file.
struct ConfigSource {
  std::filesystem::path file;  // empty: none
  std::string tracker, left_glove, right_glove, arm;
  std::shared_ptr<SharedCamera> camera = {};  // shared by the display and the trackers; null: none

  /// Reads the configuration. Throws InputError for an invalid file or address.
  ClientConfig read() const;
};

class ConfigWatch {
 public:
  explicit ConfigWatch(ConfigSource source);

  /// Returns the new configuration if its file was written since the last check, which is made at most every
  /// 0.5 s. Passes errors to `report` and returns nullopt for an invalid file.
  std::optional<ClientConfig> look(std::int64_t now_ns,
                                   const std::function<void(const std::string&)>& report);

 private:
  ConfigSource source_;
  std::filesystem::file_time_type written_{};
  std::int64_t looked_ns_ = 0;

  std::filesystem::file_time_type last_written() const;
};

}  // namespace prosector
