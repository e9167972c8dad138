#pragma once
// Where the set-up window's controls are, in a file, for scripts that click.

#include <filesystem>
#include <string>

#include "client/setup/interface.h"

namespace prosector {

class LayoutLog {
 public:
  /// Takes a file; empty: nothing is written.
  explicit LayoutLog(std::filesystem::path file) : file_(std::move(file)) {}

  /// Writes the places of all controls and what is said, once two pictures have the same: what comes anew
  /// finds its place first. The file is whole at any time.
  void write(const Interface& ui, const std::string& words);

 private:
  std::filesystem::path file_;
  std::string last_, written_;
};

}  // namespace prosector
