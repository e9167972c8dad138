#pragma once
// A user's last choices in the set-up window, saved for the next start.

#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

/// Display settings with which the user enters a session: kind of display, quality and monitor.
struct DisplaySettings {
  std::string display = "window";  // value of --display
  std::string quality = "medium";  // value of --quality; empty: adapted to --frame-time
  int monitor = -1;                // full screen on this monitor, from 0; negative: a window

  /// Returns the client's command-line arguments for these display settings, omitting those with default
  /// values.
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

/// Reads the user's last choices from the file. A missing or damaged file yields the defaults, because it
/// contains no user work.
SetupChoices recall(const std::filesystem::path& file);
/// Writes the user's choices to the file, for the next start of the set-up window. Throws InputError if the
/// file can't be written.
void remember(const SetupChoices& memory, const std::filesystem::path& file);
/// Moves the session's name to the front of the list of recently entered sessions. The list keeps at most
/// max_recent_sessions names.
void add_recent_session(SetupChoices& memory, const std::string& session);

}  // namespace prosector
