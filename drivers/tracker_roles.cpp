#include "drivers/tracker_roles.h"

namespace prosector {
namespace {

constexpr bool is_hand(StationRole role) {
  return role == StationRole::right_hand || role == StationRole::left_hand;
}

/// Makes stations 1 and 2 the hands. Other roles follow, with their boards, and each with its mount.
void put_hands_first(ClientConfig& config) {
  const ClientConfig given = config;
  DeviceConfig& device = config.tracker_device;
  config.stations = {StationRole::right_hand, StationRole::left_hand};
  device.boards = {};
  device.mount = {};
  std::size_t next = 2;
  for (std::size_t k = 0; k < max_stations; ++k) {
    const StationRole role = given.stations[k];
    if (role == StationRole::none || (!is_hand(role) && next == max_stations)) continue;
    const std::size_t station = !is_hand(role) ? next++ : role == StationRole::right_hand ? 0 : 1;
    config.stations[station] = role;
    device.mount[station] = given.tracker_device.mount[k];
    if (!is_hand(role)) device.boards[station] = given.tracker_device.boards[k];
  }
  device.stations = (1u << next) - 1;
}

}  // namespace

void settle_roles(ClientConfig& config) {
  const DriverRow& driver = driver_of(config.tracker);
  if (driver.knows_hands) put_hands_first(config);
  if (!driver.knows_head) return;
  config.stations = {StationRole::head};
  config.tracker_device.stations = 1;
}

std::string boards_address(const std::string& tracker) {
  const DriverRow& driver = driver_of(tracker);
  return driver.knows_hands && driver.is_camera ? "tags:" + first_camera(tracker) : tracker;
}

ClientConfig seen_for(ClientConfig config, StationRole role) {
  if (config.tracker.empty()) return config;
  const bool beside_hands = !is_hand(role) && boards_address(config.tracker) != config.tracker;
  if (beside_hands)
    config.tracker = boards_address(config.tracker);
  else
    settle_roles(config);
  return config;
}

}  // namespace prosector
