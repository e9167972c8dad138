#pragma once
// Assigns roles to a tracker's stations when its driver fixes some of them, and finds the device that tracks
// a role.

#include <string>

#include "drivers/config/client_config.h"

namespace prosector {

/// Replaces the configured assignment of the tracker's stations (receivers) where its driver fixes them. A
/// driver with `fixes_hand_stations` has the right and the left hand at stations 1 and 2; other roles follow.
/// A driver with `fixes_head_station` has only the head, at station 1.
void apply_driver_roles(ClientConfig& config);

/// Returns the address of the device that detects the boards (printed markers) of a tracker. For a camera
/// that tracks bare hands this is `tags` on the same camera, otherwise the tracker's own address.
std::string board_tracker_address(const std::string& tracker);

/// Returns the configuration adapted so that the tracker and its stations track `role`. For a role with a
/// printed board seen by a bare-hand camera, the tracker becomes the board detector `tags` and the stations
/// stay as configured.
ClientConfig config_for_role(ClientConfig config, StationRole role);

}  // namespace prosector
