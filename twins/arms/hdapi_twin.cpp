// A simulated arm of OpenHaptics: a library with HDAPI's functions, after its documentation and reports of
// its users. HDAPI's state is per process, and so is this twin's.
#include <time.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "common/clock.h"
#include "drivers/arms/hdapi_library.h"
#include "drivers/ports/real_time.h"
#include "twins/arms/library_twin.h"

namespace prosector::hdapi {
namespace {

constexpr std::int64_t period_ns = 1'000'000;
constexpr double mm = 1e-3, nominal_force = 3.3;  // N
constexpr int unreliable_frames = 2;              // frames after the start without a true pose
constexpr std::size_t most_errors = 100;
const Vec3 unknown_place(0, -110, -35);  // mm: reported before the first frames
const Vec3 uncalibrated(12, -5, 8);      // mm: position error before calibration

class HdapiTwin {
 public:
  HdapiTwin() {
    library.on_restart = [this] { reset(); };
    library.on_tick = [this] { tick(); };
  }
  ~HdapiTwin() { stop(); }

  LibraryTwin library{ArmMechanics{}};

  Handle open() {
    if (library.faults.away || library.arm() == nullptr) return fail(device_fault), no_device;
    if (open_) return fail(already_initiated), no_device;
    open_ = true;
    calibrated_ = false;
    return 0;
  }
  void shut() {
    open_ = forces_ = false;
    if (HeldArm* arm = library.arm()) arm->put_down();
  }
  bool usable(Handle device) {
    if (!open_ || device != 0) return fail(bad_handle), false;
    if (library.faults.away) return fail(comm_error), false;
    return true;
  }

  void begin(Handle device) {
    if (!usable(device)) return;
    if (in_frame_) return fail(illegal_begin);
    in_frame_ = true;
    force_.setZero();
  }
  void end(Handle device) {
    if (!usable(device)) return;
    if (frames_++ < unreliable_frames || !in_frame_) fail(illegal_end);
    in_frame_ = false;
    if (library.faults.force_error != 0) {
      fail(static_cast<Enum>(library.faults.force_error));
      force_.setZero();
    }
    if (const double size = force_.norm(); size > nominal_force) {
      if (!clamps_) fail(exceeded_max_force);
      force_ *= clamps_ ? nominal_force / size : 0;
    }
    library.arm()->set_force(forces_ && calibrated_ ? force_ : Vec3(Vec3::Zero()));
  }
  void enable(Enum what) {
    if (what == force_output) forces_ = true;
    if (what == max_force_clamping) clamps_ = true;
  }

  void get(Enum what, double* out) {
    if (!usable(0)) return;
    if (what == motor_temperature) {
      std::fill_n(out, 3, library.reported(library.faults.temperature));
    } else if (!in_frame_) {
      fail(frame_error);
    } else if (what == current_transform) {
      const HeldArm& arm = *library.arm();
      Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
      matrix.topLeftCorner<3, 3>() = arm.orientation().toRotationMatrix();
      matrix.topRightCorner<3, 1>() = frames_ < unreliable_frames ? unknown_place
                                      : calibrated_               ? Vec3(arm.model().measured() / mm)
                                                    : Vec3(arm.model().measured() / mm + uncalibrated);
      for (std::size_t i = 0; i < transform_size; ++i) out[i] = library.reported(matrix.data()[i]);
    } else {
      fail(0x100);
    }
  }
  void get(Enum what, int* out) {
    if (!usable(0)) return;
    if (what == current_buttons)
      *out = static_cast<int>(library.faults.buttons);
    else if (what == calibration_style)
      *out = by_inkwell;
    else
      fail(0x100);
  }
  void set(Enum what, const double* in) {
    if (!usable(0)) return;
    if (what != current_force || !in_frame_) return fail(frame_error);
    force_ = Vec3(in[0], in[1], in[2]);
  }

  const char* version() const { return library.faults.version == 3 ? "3.4.0" : "9.1"; }
  Enum calibration() {
    if (library.faults.needs_calibration) calibrated_ = library.faults.needs_calibration = false;
    return calibrated_ ? hdapi::calibrated : needs_update;
  }
  void calibrate(Enum style) {
    // Outside the scheduler's thread it has no effect and reports no error.
    if (!ticking_ || !usable(0) || style != by_inkwell) return;
    calibrated_ = true;
    library.arm()->take(library.now_ns());
  }

  ErrorInfo pop() {
    if (library.faults.error != 0) return {static_cast<Enum>(library.faults.error), 0, 0};
    if (errors_.empty()) return {success, 0, 0};
    const Enum newest = errors_.back();
    errors_.pop_back();
    return {newest, 0, 0};
  }
  void fail(Enum error) {
    if (errors_.size() < most_errors) errors_.push_back(error);
  }

  Schedule schedule(Callback callback, void* data) {
    callbacks_.push_back({++schedules_, callback, data});
    return schedules_;
  }
  void unschedule(Schedule schedule) {
    std::erase_if(callbacks_, [&](const Scheduled& s) { return s.number == schedule; });
  }
  void start() {
    running_ = true;
    frames_ = 0;
    if (library.has_own_clock()) thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
  }
  void stop() {
    running_ = false;
    thread_ = {};
  }

 private:
  struct Scheduled {
    Schedule number;
    Callback callback;
    void* data;
  };
  std::vector<Scheduled> callbacks_;
  Schedule schedules_ = 0;
  std::atomic<bool> running_ = false;
  bool open_ = false, in_frame_ = false, forces_ = false, clamps_ = false, calibrated_ = false,
       ticking_ = false;
  int frames_ = 0;
  Vec3 force_ = Vec3::Zero();
  std::vector<Enum> errors_;
  std::jthread thread_;

  void reset() {
    stop();
    callbacks_.clear();
    errors_.clear();
    open_ = in_frame_ = forces_ = clamps_ = calibrated_ = false;
  }
  void tick() {
    const std::lock_guard lock(library.mutex);
    if (!running_) return;
    ticking_ = true;
    std::erase_if(callbacks_, [](const Scheduled& s) { return s.callback(s.data) == done; });
    ticking_ = false;
  }
  void run(std::stop_token stop) {
    request_real_time_priority(servo_priority);
    for (std::int64_t next = monotonic_ns(); !stop.stop_requested();) {
      next = std::max(next + period_ns, monotonic_ns());
      const timespec until{next / 1'000'000'000, next % 1'000'000'000};
      clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
      const std::lock_guard lock(library.mutex);
      library.advance(monotonic_ns());
    }
  }
};

/// Returns the library's only twin.
HdapiTwin& twin() {
  static HdapiTwin only;
  return only;
}

}  // namespace
}  // namespace prosector::hdapi

using namespace prosector::hdapi;
using prosector::locked;

extern "C" {

Handle hdInitDevice(const char*) {
  return locked(twin(), [](auto& t) { return t.open(); });
}
void hdDisableDevice(Handle) {
  locked(twin(), [](auto& t) { t.shut(); });
}
void hdMakeCurrentDevice(Handle) {}
void hdBeginFrame(Handle device) {
  locked(twin(), [&](auto& t) { t.begin(device); });
}
void hdEndFrame(Handle device) {
  locked(twin(), [&](auto& t) { t.end(device); });
}
ErrorInfo hdGetError() {
  return locked(twin(), [](auto& t) { return t.pop(); });
}
const char* hdGetErrorString(Enum) {
  return "an error of the simulated HDAPI arm";
}
const char* hdGetString(Enum) {
  return locked(twin(), [](auto& t) { return t.version(); });
}
void hdEnable(Enum what) {
  locked(twin(), [&](auto& t) { t.enable(what); });
}
void hdGetDoublev(Enum what, double* out) {
  locked(twin(), [&](auto& t) { t.get(what, out); });
}
void hdSetDoublev(Enum what, const double* in) {
  locked(twin(), [&](auto& t) { t.set(what, in); });
}
void hdGetIntegerv(Enum what, int* out) {
  locked(twin(), [&](auto& t) { t.get(what, out); });
}
Enum hdCheckCalibration() {
  return locked(twin(), [](auto& t) { return t.calibration(); });
}
void hdUpdateCalibration(Enum style) {
  locked(twin(), [&](auto& t) { t.calibrate(style); });
}
Schedule hdScheduleAsynchronous(Callback callback, void* data, unsigned short) {
  return locked(twin(), [&](auto& t) { return t.schedule(callback, data); });
}
void hdUnschedule(Schedule schedule) {
  locked(twin(), [&](auto& t) { t.unschedule(schedule); });
}
void hdStartScheduler() {
  locked(twin(), [](auto& t) { t.start(); });
}
void hdStopScheduler() {
  twin().stop();  // waits for the thread, which takes the lock
}
prosector::LibraryTwin* prosector_twin() {
  return &twin().library;
}

}  // extern "C"
