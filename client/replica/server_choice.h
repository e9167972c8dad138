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
  /// Sets the language of body names (see Replica).
  explicit ServerChoice(std::string language = "") : language_(std::move(language)) {}

  /// Applies a sample to the replica of its writer's process. Switches to another server if the followed one
  /// is gone, or if a server with precedence appears (common/server_run.h).
  void apply(const Received& received);

  /// Returns the followed server's replica; an empty one before there is any.
  Replica& replica();
  /// Returns the process id of the followed server, as in Received::writer; 0: none yet.
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
