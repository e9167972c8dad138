#pragma once
// What a person chose last in the set-up window, kept for the next time.

#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

/// How a person sees a session.
struct SeenAs {
  std::string display = "window";  // as --display
  std::string quality = "medium";  // as --quality; empty: as quickly as --frame-time asks
  int monitor = -1;                // to fill, from 0; below: a window

  /// Returns the words of a command line, without what holds anyway.
  std::vector<std::string> words() const;
};

struct AnteroomMemory {
  std::string name;                  // as others see it
  bool watches = false;              // rather than taking part
  bool lan = false;                  // looks for sessions on the local network, too
  std::filesystem::path scene;       // hosted last
  std::vector<std::string> entered;  // sessions, the last first
  SeenAs seen;
};
inline constexpr std::size_t most_entered = 8;

/// Reads what was kept. A file that is missing or damaged is as good as none: nothing of a person's work is
/// in it.
AnteroomMemory recall(const std::filesystem::path& file);
/// Keeps it. Throws InputError where the file can't be written.
void remember(const AnteroomMemory& memory, const std::filesystem::path& file);
/// Puts a session first among those that were entered.
void note_entered(AnteroomMemory& memory, const std::string& session);

}  // namespace prosector
