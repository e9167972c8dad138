#pragma once
// The place of a session on the network: ensures that only one server hosts it, and describes how to join.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "idl/host_conflict_monitor.h"
#include "server/session/run/options.h"

namespace prosector {

/// Starts to listen for other servers that host the session. It is called before the scene is compiled, since
/// both take time.
std::unique_ptr<HostConflictMonitor> watch_for_others(const ServerOptions& options,
                                                      const std::string& session);

/// Opens the network for the session, and sets `place` to the settings with which it was opened. Throws
/// InputError if another server hosts this session, or no server index is free on this host.
std::unique_ptr<Bus> open_bus(const ServerOptions& options, const std::string& session,
                              const HostConflictMonitor& watch, BusConfig& place);

/// Calls `yield` if another server, which started at nearly the same time, turns out to host the session.
/// `server_run` identifies this server's run.
void guard_place(HostConflictMonitor& watch, std::uint64_t server_run,
                 const std::function<void(const SessionInfo& other)>& yield);
/// Throws InputError with the message that another server, `rival`, started the same session simultaneously
/// and hosts it.
[[noreturn]] void refuse_for(const SessionInfo& rival, const std::string& session);

/// Returns lines of text for the console that describe how clients join the session.
std::string how_to_join(const BusConfig& config);
/// Returns lines of text for the console that describe how clients watch a recorded session, in which nobody
/// participates.
std::string how_to_watch(const BusConfig& config);

}  // namespace prosector
