#pragma once
// Which of the servers that say they host the session a client follows. What each of them says is kept apart,
// so that two are never mixed.

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "client/replica/replica.h"

namespace prosector {

class ServerChoice {
 public:
  /// Lets bodies be called as in `language` (Replica).
  explicit ServerChoice(std::string language = "") : language_(std::move(language)) {}

  /// Takes one sample into what is known of its writer's session. Follows another server when the one that
  /// was followed is gone, or when one that precedes it is there (common/server_run.h).
  void apply(const Received& received);

  /// Returns what the followed server said; an empty one before there is any.
  Replica& replica();
  /// Returns the process of the followed server, as Received::writer says; 0: none yet.
  std::uint64_t followed() const { return followed_; }

 private:
  std::string language_;
  std::map<std::uint64_t, Replica> servers_;  // by process
  std::uint64_t followed_ = 0;
  Replica nobody_;

  bool admits(std::uint64_t writer);
  void choose();
};

}  // namespace prosector
