#include "drivers/config/tracker_roles.h"

#include "drivers/device/driver_table.h"

namespace prosector {
namespace {

constexpr bool is_hand(StationRole role) {
  return role == StationRole::right_hand || role == StationRole::left_hand;
}

/// Assigns the hands to stations 1 and 2. Other roles follow, each with its board and mount.
void put_hands_first(ClientConfig& config) {
  const ClientConfig given = config;
  DeviceConfig& device = config.tracker_device;
  config.stations = {StationRole::right_hand, StationRole::left_hand};
  device.tags.boards = {};
  device.placement.mount = {};
  std::size_t next = 2;
  for (std::size_t k = 0; k < max_stations; ++k) {
    const StationRole role = given.stations[k];
    if (role == StationRole::none || (!is_hand(role) && next == max_stations)) continue;
    const std::size_t station = !is_hand(role) ? next++ : role == StationRole::right_hand ? 0 : 1;
    config.stations[station] = role;
    device.placement.mount[station] = given.tracker_device.placement.mount[k];
    if (!is_hand(role)) device.tags.boards[station] = given.tracker_device.tags.boards[k];
  }
  device.placement.stations = (1u << next) - 1;
}

}  // namespace

void apply_driver_roles(ClientConfig& config) {
  const DriverRow& driver = driver_of(config.tracker);
  if (driver.fixes_hand_stations) put_hands_first(config);
  if (!driver.fixes_head_station) return;
  config.stations = {StationRole::head};
  config.tracker_device.placement.stations = 1;
}

std::string board_tracker_address(const std::string& tracker) {
  const DriverRow& driver = driver_of(tracker);
  return driver.fixes_hand_stations && driver.is_camera ? "tags:" + first_camera(tracker) : tracker;
}

ClientConfig config_for_role(ClientConfig config, StationRole role) {
  if (config.tracker.empty()) return config;
  const bool beside_hands = !is_hand(role) && board_tracker_address(config.tracker) != config.tracker;
  if (beside_hands)
    config.tracker = board_tracker_address(config.tracker);
  else
    apply_driver_roles(config);
  return config;
}

}  // namespace prosector
