#pragma once
// What the making of geometry reports, kept for a test.

#include <string>
#include <vector>

#include "common/anatomy/progress.h"

namespace prosector {

struct Lines {
  std::vector<std::string> lines;
  Progress progress() {
    return [this](const std::string& line) { lines.push_back(line); };
  }
  bool say(const std::string& text) const {
    for (const auto& line : lines)
      if (line.find(text) != std::string::npos) return true;
    return false;
  }
};

}  // namespace prosector
