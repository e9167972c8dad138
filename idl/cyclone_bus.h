#pragma once
// The Bus over Cyclone DDS, and what there is on the network before one joins.

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "idl/bus.h"

namespace prosector {

/// Joins the network as one end of a session. Throws InputError when the configuration is not valid or, for a
/// server, its index is taken on this host. BusConfig::profile: empty or "loopback", "lan", "wan", or a file.
std::unique_ptr<Bus> make_cyclone_bus(const BusConfig& config);

/// Returns every session that the configuration reaches, whatever its name, after listening for `timeout`.
/// Wants some 0.5 s; peers without a port are asked at all ten server indices.
std::vector<SessionInfo> list_sessions(const BusConfig& config, std::chrono::milliseconds timeout);

/// Returns the lowest server index that is free on this host, so that several sessions can share it.
std::optional<std::uint32_t> free_server_index(const BusConfig& config);

}  // namespace prosector
