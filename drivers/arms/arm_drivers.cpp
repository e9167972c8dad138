// The table of haptic arms.
#include <algorithm>

#include "drivers/arms/dhd.h"
#include "drivers/arms/hdapi.h"
#include "drivers/arms/inverse3.h"
#include "drivers/arms/omni.h"
#include "drivers/arms/vrpn_arm.h"
#include "drivers/device/arm.h"
#include "drivers/device/device_address.h"

namespace prosector {

const std::vector<ArmRow>& arm_drivers() {
  static const std::vector<ArmRow> rows = {
      {"omni", "PHANTOM Omni on a FireWire port, e.g. omni:0", open_omni},
      {"hdapi", "PHANTOM or Touch by OpenHaptics' libHD.so, e.g. hdapi:default", open_hdapi},
      {"dhd", "omega, delta, sigma or lambda arm by Force Dimension's libdhd.so, e.g. dhd:0", open_dhd},
      {"inverse3", "Haply Inverse3 by Haply's service, e.g. inverse3:localhost:10001", open_inverse3},
      {"vrpn", "a force device of a VRPN server, e.g. vrpn:Phantom0@lab", open_vrpn},
      {"omni-twin", "a simulated PHANTOM Omni at a socket, e.g. omni-twin:/tmp/omni", open_omni_twin},
  };
  return rows;
}

DeviceAddress parse_arm_address(const std::string& address) {
  return split_address("arm", address, arm_drivers());
}

std::unique_ptr<Arm> open_arm(const std::string& address, const ArmConfig& config) {
  const DeviceAddress parsed = parse_arm_address(address);
  const auto row = std::find_if(arm_drivers().begin(), arm_drivers().end(),
                                [&](const ArmRow& r) { return parsed.driver == r.name; });
  return row->open(parsed.path, config);
}

}  // namespace prosector
