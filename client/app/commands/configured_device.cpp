#include "client/app/commands/configured_device.h"

#include <fmt/format.h>

#include <array>

#include "common/error.h"
#include "drivers/config/client_config.h"

namespace prosector {
namespace {

/// A device that a configuration may have, with the name of its table.
struct NamedDevice {
  const char* table;
  ConfiguredDevice device;
};

std::array<NamedDevice, 3> devices_of(const ClientConfig& config) {
  const GloveSettings &right = config.gloves[right_hand], &left = config.gloves[left_hand];
  return {{{"tracker", {config.tracker, config.tracker_device}},
           {"glove.right", {right.address, right.device}},
           {"glove.left", {left.address, left.device}}}};
}

}  // namespace

ConfiguredDevice configured_device(const std::string& wanted, const std::filesystem::path& config) {
  const bool is_address = wanted.find(':') != std::string::npos;
  if (config.empty()) {
    if (!is_address)
      throw InputError(
          fmt::format("\"{}\" is not a device: give DRIVER:PATH, e.g. fastrak:/dev/ttyS0, or a configuration "
                      "that names the device with --config FILE",
                      wanted));
    return {wanted, {}};
  }
  const std::array<NamedDevice, 3> devices = devices_of(load_client_config(config));
  for (const auto& [table, device] : devices) {
    if (device.address.empty()) continue;
    if (is_address ? device.address == wanted : wanted.empty() || wanted == table) return device;
  }
  // For an address that is not in the configuration, use the settings of the configured tracker.
  if (is_address) return {wanted, devices.front().device.device};
  throw InputError(
      fmt::format("{}: configures no {}", config.string(),
                  wanted.empty() ? "device: add the table tracker, glove.right or glove.left" : wanted));
}

}  // namespace prosector
