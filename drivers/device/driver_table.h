#pragma once
// Table of the device drivers, and opening a device by its address. drivers/config/device_config.h defines
// the settings.

#include <memory>
#include <string>
#include <vector>

#include "drivers/device/device.h"

namespace prosector {

struct DeviceConfig;

/// One row of the table of input device drivers: the name that begins a device's address, the help text, the
/// function that opens a device, and properties of the driver.
struct DriverRow {
  const char* name;
  const char* help;  // one line for --help
  /// Opens a device at `path`, the address without the driver's name. The function passes only the groups of
  /// `config` that this driver uses.
  std::unique_ptr<Device> (*open)(const std::string& path, const DeviceConfig& config);
  bool fixes_hand_stations = false;  // station 1 is always the right hand and station 2 the left one,
                                     // regardless of the configuration
  bool is_camera = false;            // `path` is a camera address, or several separated by commas
  bool fixes_head_station = false;   // station 1 is always the head, regardless of the configuration
};

const std::vector<DriverRow>& drivers();

/// Splits an input device's address "DRIVER:PATH" into driver and path. Throws InputError for an unknown
/// driver (listing the known ones) or a missing path.
DeviceAddress parse_device_address(const std::string& address);

/// Returns the row of the driver table that an input device's address "DRIVER:PATH" names. Throws InputError
/// for an unknown driver (listing the known ones) or a missing path.
const DriverRow& driver_of(const std::string& address);

/// Returns the first of the comma-separated camera addresses in an input device's address "DRIVER:PATH".
/// Returns an empty string if the driver uses no camera.
std::string first_camera(const std::string& address);

/// Opens an input device by its address "DRIVER:PATH". Throws InputError for an unknown driver (listing the
/// known ones) or a missing path.
std::unique_ptr<Device> open_device(const std::string& address, const DeviceConfig& config);

}  // namespace prosector
