#pragma once
// The place of a session on the network: that nobody else hosts it, and how people find it.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "idl/session_watch.h"
#include "server/session/options.h"

namespace prosector {

/// Listens for other servers of the session, while the scene is compiled: both take their time.
std::unique_ptr<SessionWatch> watch_for_others(const ServerOptions& options, const std::string& session);

/// Opens the network and says where in `place`. Throws InputError when somebody hosts this session, or no
/// place is left.
std::unique_ptr<Bus> open_bus(const ServerOptions& options, const std::string& session,
                              const SessionWatch& watch, BusConfig& place);

/// Calls `yield` when it turns out that another server, which started at the same moment, hosts the session.
void guard_place(SessionWatch& watch, std::uint64_t server_run,
                 const std::function<void(const SessionInfo& other)>& yield);
/// Throws InputError that says so.
[[noreturn]] void refuse_for(const SessionInfo& rival, const std::string& session);

/// Returns the lines that tell people how to come.
std::string how_to_join(const BusConfig& config);
/// Returns the same of a recorded session, in which nobody takes part.
std::string how_to_watch(const BusConfig& config);

}  // namespace prosector
