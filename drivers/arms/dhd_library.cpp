#include "drivers/arms/dhd_library.h"

namespace prosector::dhd {

Api::Api(const SharedLibrary& library) {
  library.find("dhdGetSDKVersion", get_sdk_version);
  library.find("dhdOpen", open);
  library.find("dhdOpenID", open_id);
  library.find("dhdClose", close);
  library.find("dhdEnableForce", enable_force);
  library.find("dhdGetPosition", get_position);
  library.find("dhdGetOrientationFrame", get_orientation_frame);
  library.find("dhdGetButton", get_button);
  library.find("dhdGetStatus", get_status);
  library.find("dhdHasActiveWrist", has_active_wrist);
  library.find("dhdHasGripper", has_gripper);
  library.find("dhdEmulateButton", emulate_button);
  library.find("dhdSetForce", set_force);
  library.find("dhdSetForceAndTorque", set_force_and_torque);
  library.find("dhdErrorGetLastStr", error_get_last_str);
}

std::string last_error(const Api& api) {
  const char* words = api.error_get_last_str();
  return words != nullptr ? words : "unnamed error";
}

}  // namespace prosector::dhd
