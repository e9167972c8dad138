#include "drivers/arms/hdapi_library.h"

#include <fmt/format.h>

namespace prosector::hdapi {

Api::Api(const SharedLibrary& library) {
  library.find("hdInitDevice", init_device);
  library.find("hdDisableDevice", disable_device);
  library.find("hdMakeCurrentDevice", make_current_device);
  library.find("hdBeginFrame", begin_frame);
  library.find("hdEndFrame", end_frame);
  library.find("hdGetError", get_error);
  library.find("hdGetErrorString", get_error_string);
  library.find("hdGetString", get_string);
  library.find("hdEnable", enable);
  library.find("hdGetDoublev", get_doublev);
  library.find("hdSetDoublev", set_doublev);
  library.find("hdGetIntegerv", get_integerv);
  library.find("hdCheckCalibration", check_calibration);
  library.find("hdUpdateCalibration", update_calibration);
  library.find("hdScheduleAsynchronous", schedule_asynchronous);
  library.find("hdUnschedule", unschedule);
  library.find("hdStartScheduler", start_scheduler);
  library.find("hdStopScheduler", stop_scheduler);
}

std::string error_text(const Api& api, Enum error) {
  const char* words = api.get_error_string(error);
  return fmt::format("{} ({:04x})", words != nullptr ? words : "unnamed error", error);
}

}  // namespace prosector::hdapi
