#pragma once
// What an onlooker knows of the session, written down while it runs: a line of JSON whenever something
// changed.

#include <filesystem>
#include <fstream>
#include <string>

#include "client/replica/replica.h"

namespace prosector {

class SessionLog {
 public:
  /// Opens the file. Throws InputError when it cannot be written.
  explicit SessionLog(const std::filesystem::path& file);

  /// Reads the replica at `tick` of its playhead, `seconds` after joining. Says, each by name:
  ///   parts: who holds them, whether they are attached, hidden, lit, inspected, opacity, stiffness; of
  ///     tissue also, in m, `at`, the mean of its surface, `shift`, that mean from where it rests, and `size`
  ///     of the box around it;
  ///   panels, by whose they are: part, and of each control position, on, touched;
  ///   touches, by hand: body, force on it in N, depth in m.
  void write(Replica& replica, double tick, double seconds);

 private:
  std::ofstream out_;
  std::string last_;
};

}  // namespace prosector
