#include "client/app/desk/eye_window.h"

#include <fmt/format.h>

#include "drivers/device/driver_table.h"

namespace prosector {

EyeWindow::EyeWindow(const WindowSettings& settings)
    : settings_(settings), device_(open_device(settings.address, settings.device)) {}

WindowLook EyeWindow::look(std::int64_t now_ns, double fov) {
  samples_.clear();
  device_->poll(samples_);
  const double seconds = 1e-9 * static_cast<double>(now_ns);
  for (const DeviceSample& sample : samples_)
    if (sample.station == 0 && sample.has_pose) eye_.saw(sample.pose.p, seconds);
  return {eye_.at(seconds, resting_eye(fov, settings_.height)), settings_.height, settings_.pans};
}

std::string EyeWindow::take_news() {
  const DeviceStatus status = device_->status();
  std::string words = fmt::format("window {}: {}{}{}", settings_.address, health_name(status.health),
                                  status.message.empty() ? "" : ": ", status.message);
  if (words == last_status_) return "";
  last_status_ = words;
  return words;
}

}  // namespace prosector
