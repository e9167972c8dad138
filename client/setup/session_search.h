#pragma once
// Which sessions there are, and who is in them, looked for again and again on a thread of its own.

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "idl/bus.h"

namespace prosector {

/// A session as one sees it from outside.
struct FoundSession {
  SessionInfo info;
  std::vector<std::string> people;  // "Ada (host)", in the order of their names

  bool speaks_our_version() const { return info.version == protocol_version; }
  bool full() const { return people.size() >= info.capacity; }
};

struct SearchResult {
  std::vector<FoundSession> sessions;  // by name
  std::uint64_t rounds = 0;            // that were searched; 0: it isn't known yet what there is
  std::string problem;                 // why nothing can be found; empty: nothing is wrong
};

class SessionSearch {
 public:
  /// Begins to search where the configuration reaches.
  explicit SessionSearch(const BusConfig& where);
  ~SessionSearch();

  /// Searches there from now on, and forgets what was found before.
  void search(const BusConfig& where);
  SearchResult result() const;

 private:
  mutable std::mutex mutex_;  // of what follows
  std::condition_variable_any changed_;
  BusConfig where_;
  std::uint64_t asked_ = 0;  // how often where to search was said
  SearchResult result_;
  std::jthread thread_;

  void run(std::stop_token stop);
};

}  // namespace prosector
