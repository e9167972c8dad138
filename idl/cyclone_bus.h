#pragma once
// The Bus over Cyclone DDS, and discovery of sessions before joining one.

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "idl/bus.h"

namespace prosector {

/// Creates a bus over Cyclone DDS that joins the configured session. Throws InputError if the configuration
/// isn't valid or, for a server, its index is taken on this host. BusConfig::profile is empty or "loopback",
/// "lan", "wan", or a file.
std::unique_ptr<Bus> make_cyclone_bus(const BusConfig& config);

/// Returns all sessions that are reached with the network configuration, whatever their names, after
/// listening for `timeout`. About 0.5 s is needed. Peers without a port are queried at all ten server
/// indices.
std::vector<SessionInfo> list_sessions(const BusConfig& config, std::chrono::milliseconds timeout);

/// Returns the lowest server index (which determines a server's UDP port) that is free on this host, so that
/// several sessions can share the host. Returns nullopt if all are in use.
std::optional<std::uint32_t> find_free_server_index(const BusConfig& config);

}  // namespace prosector
