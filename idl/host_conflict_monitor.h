#pragma once
// Detection of other servers of the same session. Runs before hosting and for a while afterwards, since two
// servers that start simultaneously don't detect each other at first.

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "idl/bus.h"

namespace prosector {

class HostConflictMonitor {
 public:
  /// Starts a thread that listens for servers that host the session config.session. Throws InputError if the
  /// network can't be opened as configured.
  explicit HostConflictMonitor(const BusConfig& config);
  ~HostConflictMonitor();
  HostConflictMonitor(const HostConflictMonitor&) = delete;
  HostConflictMonitor& operator=(const HostConflictMonitor&) = delete;

  /// Returns another server of the session as soon as one is known. Returns nullopt once the monitor has
  /// listened for `time` in total without finding one.
  std::optional<SessionInfo> other(std::chrono::milliseconds time) const;
  /// Continues to listen for other servers of the session for `time` from now. Calls `yield` once, on the
  /// monitor's thread, if a server is found whose run has precedence over the run `own`
  /// (common/server_run.h). It then stops listening.
  void guard(std::uint64_t own, std::chrono::milliseconds time,
             std::function<void(const SessionInfo& other)> yield);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
