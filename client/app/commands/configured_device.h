#pragma once
// Selects the device of a command, by its address or by its table in the configuration.

#include <filesystem>
#include <string>

#include "drivers/config/device_config.h"

namespace prosector {

struct ConfiguredDevice {
  std::string address;  // DRIVER:PATH
  DeviceConfig device;  // settings from the configuration, else the defaults
};

/// Returns address and settings of the device that a command uses. `wanted` is an address, or "tracker",
/// "glove.right" or "glove.left" of the configuration file `config`; empty: the first of these in the file.
/// `config` is empty if there is no file. Throws InputError if the file can't be read or has no such device.
ConfiguredDevice configured_device(const std::string& wanted, const std::filesystem::path& config);

}  // namespace prosector
