#pragma once
// Continuous search for sessions and their users, on a separate thread.

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "idl/bus.h"

namespace prosector {

/// Session found on the network: the server's description of it and its participants.
struct FoundSession {
  SessionInfo info;
  std::vector<std::string> people;  // "Ada (host)", sorted by name

  bool speaks_our_version() const { return info.version == protocol_version; }
  bool full() const { return people.size() >= info.capacity; }
};

struct SearchResult {
  std::vector<FoundSession> sessions;  // by name
  std::uint64_t rounds = 0;            // number of completed searches; 0: nothing is known yet
  std::string problem;                 // reason why the search fails; empty: no problem
};

class SessionSearch {
 public:
  /// Starts a thread that searches the network described by `where` for sessions again and again.
  explicit SessionSearch(const BusConfig& where);
  ~SessionSearch();

  /// Searches the network described by `where` from now on, and discards the results so far.
  void search(const BusConfig& where);
  SearchResult result() const;

 private:
  mutable std::mutex mutex_;  // guards the following members
  std::condition_variable_any changed_;
  BusConfig where_;
  std::uint64_t asked_ = 0;  // counter of calls of search()
  SearchResult result_;
  std::jthread thread_;

  void run(std::stop_token stop);
};

}  // namespace prosector
