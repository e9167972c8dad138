#include "drivers/arms/hdapi_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "common/error.h"
#include "drivers/device/plausible.h"

namespace prosector::hdapi {
namespace {

constexpr int known_major = 3;                   // supported major version
constexpr int required_clean_frames = 3;         // error-free frames needed after the start, since the first
                                                 // frames report a wrong pose
constexpr int max_bad_frames = 100;              // consecutive frames with errors after which the device is
                                                 // reopened
constexpr int most_errors = 16;                  // maximum errors read in one call, in case the stack never
                                                 // empties
constexpr double hot = 0.9;                      // motor temperature that counts as hot, of 0 … 1
constexpr std::int64_t warm_ns = 1'000'000'000;  // duration for which motors count as hot after an error
constexpr double mm = 1e-3;

/// Returns whether a library's version text may be a supported version. A text without a number is accepted.
bool may_be_known(const std::string& found_version) {
  const auto number = found_version.find_first_of("0123456789");
  return number == std::string::npos || std::atoi(found_version.c_str() + number) == known_major;
}

}  // namespace

Session::Session(const LibraryAddress& address, const Quat& room_arm, std::function<std::int64_t()> clock)
    : api_(SharedLibrary(address.library)), clock_(std::move(clock)), room_arm_(room_arm) {
  pop_errors();
  device_ = api_.init_device(address.device == "default" ? nullptr : address.device.c_str());
  Enum error = pop_errors();
  if (error == success && device_ == no_device) error = bad_handle;
  if (error != success) {
    if (device_ != no_device) api_.disable_device(device_);
    throw InputError(
        fmt::format("device '{}' cannot be opened: {}", address.device, error_text(api_, error)));
  }
  api_.make_current_device(device_);
  const char* version_text = api_.get_string(version);  // available once a device is open
  const std::string found_version = version_text != nullptr ? version_text : "";
  if (!may_be_known(found_version)) {
    api_.disable_device(device_);
    throw InputError(fmt::format("library '{}' has version '{}'; supported: {}", address.library,
                                 found_version, known_major));
  }
  pop_errors();
  api_.enable(force_output);
  api_.enable(max_force_clamping);
  api_.enable(force_ramping);
  schedule_ = api_.schedule_asynchronous(scheduler_callback, this, usual_priority);
  api_.start_scheduler();
  error = pop_errors();
  // The first frames may already fail; judge() handles these errors.
  if (error == success || error >> 8 == frame_error >> 8) return;
  close();
  throw InputError(fmt::format("device '{}' cannot be started: {}", address.device, error_text(api_, error)));
}

void Session::close() {
  api_.stop_scheduler();
  api_.unschedule(schedule_);
  api_.disable_device(device_);
}

Enum Session::scheduler_callback(void* session) {
  return static_cast<Session*>(session)->tick();
}

Enum Session::tick() {
  sample_.time_ns = clock_();
  api_.begin_frame(device_);
  const Enum calibration = api_.check_calibration();
  const Enum unread = read();
  const bool may = sample_.reading.valid && calibration == calibrated && clean_ >= required_clean_frames;
  const Vec3 force =
      may ? Vec3(room_arm_.conjugate() * exchange_.force(sample_.time_ns)) : Vec3(Vec3::Zero());
  api_.set_doublev(current_force, force.data());
  api_.end_frame(device_);
  const Enum unsent = pop_errors();
  judge(unread != success ? unread : unsent, calibration);
  calibrate(calibration);
  exchange_.publish(sample_);
  return sample_.condition == lost ? done : again;
}

/// Reads the frame's pose, buttons and motor temperatures. Returns the frame's error.
Enum Session::read() {
  std::array<double, transform_size> transform{};
  int buttons = 0;
  api_.get_doublev(current_transform, transform.data());
  api_.get_integerv(current_buttons, &buttons);
  const Enum error = pop_errors();
  const Eigen::Map<const Eigen::Matrix4d> matrix(transform.data());
  const auto pose =
      plausible_pose(mm * matrix.topRightCorner<3, 1>(), Mat3(matrix.topLeftCorner<3, 3>()), arm_reach);
  has_pose_ = pose.has_value();
  sample_.reading.valid = error == success && has_pose_;
  if (sample_.reading.valid) sample_.reading.stylus = *pose;
  sample_.reading.buttons = static_cast<std::uint32_t>(buttons);

  std::array<double, most_motors> temperatures{};
  if (reports_temperature_) {
    api_.get_doublev(motor_temperature, temperatures.data());
    reports_temperature_ = pop_errors() == success || error != success;
  }
  sample_.reading.hot =
      sample_.time_ns < warm_until_ns_ ||
      std::any_of(temperatures.begin(), temperatures.end(), [](double t) { return t >= hot; });
  return error;
}

/// Updates the sample's condition, validity and counts from the frame's errors.
void Session::judge(Enum error, Enum calibration) {
  const bool passes = error >> 8 == warm_motors >> 8;  // error of the force only
  const bool clean = error == success || passes;
  if (error == warm_motors) warm_until_ns_ = sample_.time_ns + warm_ns;
  // A refused force restarts from zero.
  if (passes && error != warm_motors) ++sample_.jumps;
  clean_ = clean ? std::min(clean_ + 1, required_clean_frames) : 0;
  bad_ = clean ? 0 : bad_ + 1;
  const bool awake = clean_ >= required_clean_frames;
  sample_.reading.valid = sample_.reading.valid && awake && calibration == calibrated;
  ++(clean && has_pose_ ? sample_.records : sample_.bad);
  sample_.code = static_cast<int>(error);
  if (error >> 8 == device_fault >> 8 || bad_ >= max_bad_frames)
    sample_.condition = lost;
  else if (!awake)
    sample_.condition = waking;
  else if (calibration != calibrated)
    sample_.condition = calibration == needs_hand ? wants_hand : being_calibrated;
  else
    sample_.condition = passes ? refused : well;
}

/// Calibrates when the device requests it. The pose may jump.
void Session::calibrate(Enum state) {
  if (clean_ < required_clean_frames || state == calibrated) return;
  ++sample_.jumps;
  if (state != needs_update) return;
  int styles = 0;
  api_.get_integerv(calibration_style, &styles);
  const auto offers = [&](Enum style) { return (static_cast<Enum>(styles) & style) != 0; };
  if (offers(automatic)) {
    api_.update_calibration(automatic);
  } else if (offers(by_inkwell)) {
    api_.update_calibration(by_inkwell);
  } else if (sample_.reading.buttons != 0) {
    // The current position becomes the rest position, so the user must confirm it with a button.
    api_.update_calibration(by_encoder_reset);
  } else {
    sample_.condition = wants_hand;
  }
  pop_errors();
}

/// Empties the error stack. Returns the newest error, or `success` if the stack was empty.
Enum Session::pop_errors() {
  const Enum newest = api_.get_error().code;
  if (newest == success) return success;
  for (int k = 1; k < most_errors && api_.get_error().code != success;) ++k;
  return newest;
}

}  // namespace prosector::hdapi
