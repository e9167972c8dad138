#pragma once
// Positions of the set-up window's controls in a file, for test scripts that click.

#include <filesystem>
#include <string>

#include "client/setup/interface.h"

namespace prosector {

class LayoutLog {
 public:
  /// Sets the file; empty: nothing is written.
  explicit LayoutLog(std::filesystem::path file) : file_(std::move(file)) {}

  /// Writes the positions of all controls and the message, once they are equal in two frames, because the
  /// layout of new controls takes a frame to settle. The file is replaced atomically.
  void write(const Interface& ui, const std::string& words);

 private:
  std::filesystem::path file_;
  std::string last_, written_;
};

}  // namespace prosector
