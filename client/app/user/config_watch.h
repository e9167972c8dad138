#pragma once
// Watches the configuration file while a client runs; changes take effect immediately.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "drivers/config/client_config.h"

namespace prosector {

/// Source of a client's device configuration: a file, and addresses from the command line, which override
/// those in the file.
struct ConfigSource {
  std::filesystem::path file;  // empty: none
  std::string tracker, left_glove, right_glove, arm;
  std::shared_ptr<SharedCamera> camera = {};  // shared by the display and the trackers; null: none

  /// Reads the configuration file and applies the command line's addresses. Throws InputError for an invalid
  /// file or address.
  ClientConfig read() const;
};

class ConfigWatch {
 public:
  explicit ConfigWatch(ConfigSource source);

  /// Returns the new configuration if its file was written since the last check, otherwise nullopt. It checks
  /// at most every 0.5 s. For an invalid file, passes the error to `report` and returns nullopt.
  std::optional<ClientConfig> look(std::int64_t now_ns,
                                   const std::function<void(const std::string&)>& report);

 private:
  ConfigSource source_;
  std::filesystem::file_time_type written_{};
  std::int64_t looked_ns_ = 0;

  std::filesystem::file_time_type last_written() const;
};

}  // namespace prosector
