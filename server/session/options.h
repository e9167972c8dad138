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
  std::string session;  // empty: the scene's
  int threads = 0;
  std::filesystem::path journal, play, replay, resume, summary;
  std::vector<std::filesystem::path> export_journal;  // from, to; empty: none
  double journal_mb = 0;                              // 0: no limit
  double seconds = 0;                                 // 0: until interrupted
  std::uint32_t domain = 0;
  std::optional<std::string> interface;  // none: this machine only; empty: the only network that there is
  std::string profile;
  std::optional<std::uint32_t> index;
  std::vector<std::filesystem::path> data;
  std::filesystem::path cache;
  bool check = false;
  bool watch = false;  // load the scene anew when its files change

  /// Returns network settings; the session's name and the index are still to be filled in.
  BusConfig bus() const;
};

/// Returns the exit status when the command line asks for no run (--help, --version, a mistake).
std::optional<int> parse_options(int argc, char** argv, ServerOptions& options);

}  // namespace prosector
