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
  /// Starts a server with the scene. Throws InputError if the program is missing.
  Hosting(const std::filesystem::path& scene, const BusConfig& where);

  void poll() { server_.poll(); }
  /// Returns whether users can enter the session.
  bool open() const { return !server_.ended() && server_.said(" is open "); }
  bool over() const { return server_.ended().has_value(); }
  /// Returns the server's last message.
  std::string words() const { return server_.lines().empty() ? "starting" : server_.lines().back(); }
  const std::string& session() const { return session_; }
  const std::filesystem::path& scene() const { return scene_; }

 private:
  std::filesystem::path scene_;
  std::string session_;
  ChildProcess server_;
};

/// Returns the command-line arguments that select the network: " --domain 3 --lan eth0".
std::vector<std::string> network_words(const BusConfig& where);

}  // namespace prosector
