#pragma once
// Every device that is reached by a network or a socket, with what plays it, for tests over all.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/config/device_config.h"
#include "drivers/ports/device_port.h"
#include "drivers/trackers/igtl_device.h"
#include "drivers/trackers/vrpn_device.h"
#include "twins/trackers/igtl_twin.h"
#include "twins/trackers/tracker_clock.h"
#include "twins/trackers/vrpn_tracker_twin.h"

namespace prosector {

struct DeviceKind {
  std::string name;
  std::function<std::unique_ptr<Device>(std::unique_ptr<DevicePort>, const DeviceConfig&)> device;
  std::function<std::unique_ptr<Twin>(const TrackerTwinOptions&, std::int64_t now_ns)> twin;
};

inline const std::vector<DeviceKind>& device_kinds() {
  static const std::vector<DeviceKind> kinds = {
      {"vrpn",
       [](auto port, const DeviceConfig& config) {
         return std::make_unique<VrpnDevice>("Tracker0", std::move(port), config.placement, config.gestures,
                                             config.glove);
       },
       [](const TrackerTwinOptions& options, std::int64_t now_ns) {
         return std::make_unique<VrpnTrackerTwin>("Tracker0", options, now_ns);
       }},
      {"igtl",
       [](auto port, const DeviceConfig& config) {
         return std::make_unique<IgtlDevice>(std::vector<std::string>{}, std::move(port), config.placement);
       },
       [](const TrackerTwinOptions& options, std::int64_t now_ns) {
         return std::make_unique<IgtlTwin>(options, now_ns);
       }},
  };
  return kinds;
}

}  // namespace prosector
