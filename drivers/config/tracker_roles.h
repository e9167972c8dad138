#pragma once
// Assigns roles to a tracker's stations when its driver fixes some of them, and finds the device that tracks
// a role.

#include <string>

#include "drivers/config/client_config.h"

namespace prosector {

/// Overrides the configured stations with those that the driver fixes. A driver with `fixes_hand_stations`
/// has hands at stations 1 and 2, and other roles follow; one with `fixes_head_station` has the head at
/// station 1.
void apply_driver_roles(ClientConfig& config);

/// Returns the address at which a tracker's boards are detected: `tags` on the same camera for a bare-hand
/// tracker, otherwise the tracker's own address.
std::string board_tracker_address(const std::string& tracker);

/// Returns the configuration with the tracker and station that track a role. A role with a board in a
/// bare-hand camera's view keeps its configured station.
ClientConfig config_for_role(ClientConfig config, StationRole role);

}  // namespace prosector
