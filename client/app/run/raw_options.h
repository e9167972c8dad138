#pragma once
// Values of command-line options as the user wrote them.

#include <optional>
#include <string>
#include <vector>

namespace prosector {

/// Command-line options of prosector-client whose texts are interpreted after the whole line was read, since
/// their meaning depends on other options.
struct RawOptions {
  std::string tracker, glove, glove_left, arm, config, size, camera, window, user_name, language,
      display = "window", quality = "medium", show = "none";
  std::optional<std::string> lan;  // interface name; empty: the only network interface
  std::vector<std::string> screenshots, effects, offers, phantoms;
  bool offers_camera = false;
  std::optional<double> detail;
};

}  // namespace prosector
