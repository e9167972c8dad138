#pragma once
// The device that a command is about: by its address, or by the table of a configuration that names it.

#include <filesystem>
#include <string>

#include "drivers/device.h"

namespace prosector {

struct ConfiguredDevice {
  std::string address;  // DRIVER:PATH
  DeviceConfig device;  // as the configuration says, else by defaults
};

/// Returns the device that is wanted: an address, or "tracker", "glove.right", "glove.left" of the
/// configuration; empty: the first of these that it names. `config`: empty for none. Throws InputError where
/// the configuration can't be read, or names no such device.
ConfiguredDevice configured_device(const std::string& wanted, const std::filesystem::path& config);

}  // namespace prosector
