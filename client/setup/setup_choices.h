#pragma once
// A user's last choices in the set-up window, saved for the next start.

#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

/// Display settings of a session.
struct DisplaySettings {
  std::string display = "window";  // value of --display
  std::string quality = "medium";  // value of --quality; empty: adapted to --frame-time
  int monitor = -1;                // full screen on this monitor, from 0; negative: a window

  /// Returns the command-line arguments, without defaults.
  std::vector<std::string> words() const;
};

struct SetupChoices {
  std::string name;                  // displayed to others
  bool watches = false;              // joins as an observer
  bool lan = false;                  // searches the local network, too
  std::filesystem::path scene;       // last hosted scene
  std::vector<std::string> entered;  // sessions, the last one first
  DisplaySettings seen;
};
inline constexpr std::size_t max_recent_sessions = 8;

/// Reads the file. A missing or damaged file counts as empty, because it contains no user work.
SetupChoices recall(const std::filesystem::path& file);
/// Saves the choices. Throws InputError if the file can't be written.
void remember(const SetupChoices& memory, const std::filesystem::path& file);
/// Moves a session to the front of the entered ones.
void add_recent_session(SetupChoices& memory, const std::string& session);

}  // namespace prosector
