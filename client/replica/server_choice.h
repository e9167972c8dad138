#pragma once
// Selects the server to follow if several claim to host the session. Each server has its own replica, so that
// their data is never mixed.

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "client/replica/replica.h"

namespace prosector {

class ServerChoice {
 public:
  /// Starts without a server. `language` is the tag of the language in which body names are shown; empty: as
  /// the scene's author wrote them.
  explicit ServerChoice(std::string language = "") : language_(std::move(language)) {}

  /// Applies a received message to the replica of the server process that wrote it. Switches to another
  /// server if the followed one is gone, or if a server with precedence (common/server_run.h) appears.
  void apply(const Received& received);

  /// Returns the replica of the followed server; an empty replica before any server is found.
  Replica& replica();
  /// Returns the process id of the followed server, as in Received::writer; 0 if no server is followed yet.
  std::uint64_t followed() const { return followed_; }

 private:
  std::string language_;
  std::map<std::uint64_t, Replica> servers_;  // by process id
  std::uint64_t followed_ = 0;
  Replica empty_replica_;

  bool admits(std::uint64_t writer);
  void choose();
};

}  // namespace prosector
