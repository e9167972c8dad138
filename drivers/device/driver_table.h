#pragma once
// Table of the device drivers, and opening a device by its address. drivers/config/device_config.h defines
// the settings.

#include <memory>
#include <string>
#include <vector>

#include "drivers/device/device.h"

namespace prosector {

struct DeviceConfig;

/// One row of the table of device drivers.
struct DriverRow {
  const char* name;
  const char* help;  // one line for --help
  /// Opens a device. Passes the driver its own groups of the configuration only.
  std::unique_ptr<Device> (*open)(const std::string& path, const DeviceConfig& config);
  bool fixes_hand_stations = false;  // station 1 is always the right hand and station 2 the left one,
                                     // regardless of the configuration
  bool is_camera = false;            // `path` is a camera address, or several separated by commas
  bool fixes_head_station = false;   // station 1 is always the head, regardless of the configuration
};

const std::vector<DriverRow>& drivers();

/// Parses an address. Throws InputError for an unknown driver (listing the known ones) or a missing path.
DeviceAddress parse_device_address(const std::string& address);

/// Returns the driver row of an address. Throws InputError for an unknown driver (listing the known ones).
const DriverRow& driver_of(const std::string& address);

/// Returns the first camera address in a device's address; empty if the device has no camera.
std::string first_camera(const std::string& address);

/// Opens a device by address. Throws InputError for an unknown driver (listing the known ones).
std::unique_ptr<Device> open_device(const std::string& address, const DeviceConfig& config);

}  // namespace prosector
