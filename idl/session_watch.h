#pragma once
// Who else hosts a session: listened for before hosting it, and for a while after, since two servers that
// start at the same moment both hear nobody.

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "idl/bus.h"

namespace prosector {

class SessionWatch {
 public:
  /// Listens from now on, on a thread of its own, for servers of config.session. Throws InputError when the
  /// network can't be opened as configured.
  explicit SessionWatch(const BusConfig& config);
  ~SessionWatch();
  SessionWatch(const SessionWatch&) = delete;
  SessionWatch& operator=(const SessionWatch&) = delete;

  /// Returns a server of the session, as soon as one is known; none once the watch has listened for `time` in
  /// all.
  std::optional<SessionInfo> other(std::chrono::milliseconds time) const;
  /// Calls `yield`, for `time` from now, once and on the watch's thread, when a server is known that precedes
  /// the run `own` (common/server_run.h). Then the watch ends.
  void guard(std::uint64_t own, std::chrono::milliseconds time,
             std::function<void(const SessionInfo& other)> yield);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
