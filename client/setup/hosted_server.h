#pragma once
// A server started by the set-up window. It keeps running while its host enters and leaves.

#include <filesystem>
#include <string>
#include <vector>

#include "client/setup/child_process.h"
#include "idl/bus.h"

namespace prosector {

class Hosting {
 public:
  /// Starts a server process that hosts the scene in the session and network of `where`. Throws InputError if
  /// the server program is missing.
  Hosting(const std::filesystem::path& scene, const BusConfig& where);

  void poll() { server_.poll(); }
  /// Returns whether the hosted server is ready, so that users can join its session.
  bool open() const { return !server_.ended() && server_.said(" is open "); }
  bool over() const { return server_.ended().has_value(); }
  /// Returns the last line that the hosted server has printed; "starting" before the first.
  std::string words() const { return server_.lines().empty() ? "starting" : server_.lines().back(); }
  const std::string& session() const { return session_; }
  const std::filesystem::path& scene() const { return scene_; }

 private:
  std::filesystem::path scene_;
  std::string session_;
  ChildProcess server_;
};

/// Returns the command-line arguments that select the network: domain, local network with its interface, and
/// peers. Example: {"--domain", "3", "--lan", "eth0"}.
std::vector<std::string> network_words(const BusConfig& where);

}  // namespace prosector
