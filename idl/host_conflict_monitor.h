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
  /// Starts a thread that listens for servers of config.session. Throws InputError if the network can't be
  /// opened as configured.
  explicit HostConflictMonitor(const BusConfig& config);
  ~HostConflictMonitor();
  HostConflictMonitor(const HostConflictMonitor&) = delete;
  HostConflictMonitor& operator=(const HostConflictMonitor&) = delete;

  /// Returns another server of the session as soon as one is known, or nullopt after the watch has listened
  /// for `time` in total.
  std::optional<SessionInfo> other(std::chrono::milliseconds time) const;
  /// Watches for `time` from now. Calls `yield` once, on the watch's thread, if a server with precedence over
  /// the run `own` is found (common/server_run.h), and then ends.
  void guard(std::uint64_t own, std::chrono::milliseconds time,
             std::function<void(const SessionInfo& other)> yield);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
