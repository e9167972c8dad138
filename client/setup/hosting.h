#pragma once
// A server that the set-up window started. It stays while its host goes in and comes out again.

#include <filesystem>
#include <string>
#include <vector>

#include "client/setup/child_process.h"
#include "idl/bus.h"

namespace prosector {

class Hosting {
 public:
  /// Starts a server of the scene. Throws InputError where the program is missing.
  Hosting(const std::filesystem::path& scene, const BusConfig& where);

  void poll() { server_.poll(); }
  /// Tells whether people can enter it.
  bool open() const { return !server_.ended() && server_.said(" is open "); }
  bool over() const { return server_.ended().has_value(); }
  /// Returns what it said last, for people.
  std::string words() const { return server_.lines().empty() ? "starting" : server_.lines().back(); }
  const std::string& session() const { return session_; }
  const std::filesystem::path& scene() const { return scene_; }

 private:
  std::filesystem::path scene_;
  std::string session_;
  ChildProcess server_;
};

/// Returns the words of a command line that lead to that network: " --domain 3 --lan eth0".
std::vector<std::string> network_words(const BusConfig& where);

}  // namespace prosector
