#pragma once
// Log of the session as an observer sees it: a line of JSON whenever the state changed.

#include <filesystem>
#include <fstream>
#include <string>

#include "client/replica/replica.h"

namespace prosector {

class SessionLog {
 public:
  /// Opens the log file. Throws InputError if it cannot be written.
  explicit SessionLog(const std::filesystem::path& file);

  /// Writes the replica's state at the tick `tick`, `seconds` after joining, as a line of JSON if it changed.
  /// The objects are keyed by name:
  /// - parts: holders; whether attached, hidden, lit and inspected; opacity; stiffness; for tissue also, in
  ///   m: `at`, the mean position of its surface, `shift`, its displacement from the mean at rest, and
  ///   `size`, that of its bounding box;
  /// - panels, by owner: part, and each control's position and whether it is on and touched;
  /// - touches, by hand: body, force on it in N, and depth in m.
  void write(Replica& replica, double tick, double seconds);

 private:
  std::ofstream out_;
  std::string last_;
};

}  // namespace prosector
