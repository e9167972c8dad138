#pragma once
// The place of a session on the network: ensures that only one server hosts it, and describes how to join.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "idl/host_conflict_monitor.h"
#include "server/session/run/options.h"

namespace prosector {

/// Listens for other servers of the session while the scene is compiled, since both take time.
std::unique_ptr<HostConflictMonitor> watch_for_others(const ServerOptions& options,
                                                      const std::string& session);

/// Opens the network, and sets `place` to its settings. Throws InputError when another server hosts this
/// session, or no server index is free.
std::unique_ptr<Bus> open_bus(const ServerOptions& options, const std::string& session,
                              const HostConflictMonitor& watch, BusConfig& place);

/// Calls `yield` when another server, which started at the same moment, turns out to host the session.
void guard_place(HostConflictMonitor& watch, std::uint64_t server_run,
                 const std::function<void(const SessionInfo& other)>& yield);
/// Throws InputError with a message about the other server.
[[noreturn]] void refuse_for(const SessionInfo& rival, const std::string& session);

/// Returns lines of text that describe how to join.
std::string how_to_join(const BusConfig& config);
/// Returns lines of text that describe how to watch a recorded session, in which nobody participates.
std::string how_to_watch(const BusConfig& config);

}  // namespace prosector
