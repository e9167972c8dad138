#pragma once
// The command line of prosector-server.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "idl/bus.h"

namespace prosector {

struct ServerOptions {
  std::filesystem::path scene;
  std::string session;  // empty: the scene's name
  int threads = 0;
  std::filesystem::path journal, play, replay, resume, summary;
  std::vector<std::filesystem::path> export_journal;  // from, to; empty: none
  double journal_mb = 0;                              // 0: no limit
  double seconds = 0;                                 // 0: until interrupted
  std::uint32_t domain = 0;
  std::optional<std::string> interface;  // none: this machine only; empty: the only network interface
  std::string profile;
  std::optional<std::uint32_t> index;
  std::vector<std::filesystem::path> data;
  std::filesystem::path cache;
  bool check = false;
  bool watch = false;  // reload the scene when its files change

  /// Returns the network settings that the command line specifies. The caller sets the session's final name
  /// and the server index later.
  BusConfig bus() const;
};

/// Parses the command line into `options`. Returns the exit status if the program should end (after --help,
/// --version or an error), and nothing if it should run.
std::optional<int> parse_options(int argc, char** argv, ServerOptions& options);

}  // namespace prosector
