#include "drivers/camera/devices/camera_samples.h"

#include <algorithm>

#include "common/clock.h"
#include "drivers/device/plausible.h"

namespace prosector {
namespace {

constexpr std::size_t most_waiting = 256;  // samples; the oldest is dropped first
constexpr std::size_t most_frame_times = 64;
constexpr std::int64_t no_detection_timeout_ns = 1'000'000'000;  // time without a detection after which the
                                                                 // status reports it

}  // namespace

void CameraSamples::put(std::int64_t time_ns, bool counts, std::span<const DeviceSample> found) {
  const std::lock_guard lock(mutex_);
  if (counts && frames_ns_.size() < most_frame_times) frames_ns_.push_back(time_ns);
  for (const DeviceSample& sample : found) {
    if (found_.size() == most_waiting) found_.pop_front();
    found_.push_back(sample);
  }
  if (!found.empty()) seen_ns_ = time_ns;
}

void CameraSamples::set_guessed(bool guessed) {
  const std::lock_guard lock(mutex_);
  is_guessed_ = guessed;
}

void CameraSamples::poll(const CameraState& camera, std::vector<DeviceSample>& out) {
  const std::int64_t now_ns = monotonic_ns();
  const bool opened = camera.opened > opened_;
  if (opened) health_.opened(now_ns);
  opened_ = camera.opened;
  {
    const std::lock_guard lock(mutex_);
    if (opened) seen_ns_ = now_ns;  // detection has just started
    const auto bytes = 3 * static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
    for (const std::int64_t time_ns : frames_ns_) health_.record(std::max(time_ns, now_ns - 1), bytes);
    frames_ns_.clear();
    const std::size_t before = out.size();
    out.insert(out.end(), found_.begin(), found_.end());
    found_.clear();
    health_.garbage(now_ns, remove_implausible(out, before));
  }
  if (opened_ > 0 && !camera.is_open) health_.lost();
}

DeviceStatus CameraSamples::status(const std::string& problem, const char* unseen) const {
  DeviceStatus out = health_.status(monotonic_ns());
  if (!problem.empty()) {
    out.message = problem;
    return out;
  }
  if (opened_ == 0) {
    out.health = DeviceHealth::connecting;
    out.message = "the camera is being opened; wait";
    return out;
  }
  const std::lock_guard lock(mutex_);
  if (out.health == DeviceHealth::silent)
    out.message = "the camera is open but delivers no images: unplug it and plug it in again";
  else if (out.health == DeviceHealth::streaming && monotonic_ns() - seen_ns_ > no_detection_timeout_ns)
    out.message = unseen;
  else if (is_guessed_)
    out.message =
        "the camera is not calibrated: positions have an error of about 10 % (prosector-client camera "
        "calibrate)";
  return out;
}

}  // namespace prosector
