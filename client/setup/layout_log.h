#pragma once
// Positions of the set-up window's controls in a file, for test scripts that click.

#include <filesystem>
#include <string>

#include "client/setup/interface.h"

namespace prosector {

class LayoutLog {
 public:
  /// Sets the file to which write() writes the positions of the controls; empty: nothing is written.
  explicit LayoutLog(std::filesystem::path file) : file_(std::move(file)) {}

  /// Writes the positions of the window's controls and the message `words` to the file as JSON. It waits
  /// until they are equal in two successive frames, because the layout of new controls takes a frame to
  /// settle. The file is replaced atomically.
  void write(const Interface& ui, const std::string& words);

 private:
  std::filesystem::path file_;
  std::string last_, written_;
};

}  // namespace prosector
