#include "twins/camera/synthetic_camera.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "common/clock.h"
#include "common/error.h"
#include "twins/camera/painted_clock.h"

namespace prosector {
namespace {

constexpr double slow_period = 1;  // s between images during a `slow` fault

}  // namespace

SyntheticCamera::SyntheticCamera(SyntheticScene scene, std::int64_t start_ns)
    : painter_(std::move(scene)), start_ns_(start_ns) {}

double SyntheticCamera::seconds(std::int64_t now_ns) const {
  return static_cast<double>(now_ns - start_ns_) * 1e-9;
}

bool SyntheticCamera::has_fault(CameraFault fault, double at) const {
  const auto& faults = painter_.scene().faults;
  return std::any_of(faults.begin(), faults.end(), [&](const CameraFaultSpan& span) {
    return span.fault == fault && at >= span.from && at < span.to;
  });
}

std::optional<Frame> SyntheticCamera::next(std::chrono::milliseconds time_limit) {
  const SyntheticScene& scene = painter_.scene();
  const double now = seconds(monotonic_ns());
  if (has_fault(CameraFault::unplugged, now))
    throw InputError("synthetic camera: unplugged at this time, as its scene file specifies");
  // The newest image that is due by now, or the first one not yet delivered.
  const double shows = now - scene.delay - scene.exposure / 2;
  const auto newest = static_cast<std::int64_t>(std::floor(shows * scene.rate - 0.5));
  next_ = std::max(next_, static_cast<std::uint64_t>(std::max<std::int64_t>(0, newest)));
  while (has_fault(CameraFault::slow, scene.seconds_of(next_)) &&
         scene.seconds_of(next_) < last_shown_ + slow_period)
    ++next_;
  const double due = scene.seconds_of(next_) + scene.exposure / 2 + scene.delay;
  const double patient = static_cast<double>(time_limit.count()) * 1e-3;
  if (due - now > patient) {
    std::this_thread::sleep_for(time_limit);
    return std::nullopt;
  }
  Frame frame;
  frame.number = next_++;
  last_shown_ = scene.seconds_of(frame.number);
  frame.time_ns = start_ns_ + static_cast<std::int64_t>(1e9 * last_shown_);
  frame.image = painter_.paint(frame.number);
  if (scene.clock) paint_clock(frame.image, frame.time_ns);
  const double left = due - seconds(monotonic_ns());
  if (left > 0) std::this_thread::sleep_for(std::chrono::duration<double>(left));
  return frame;
}

}  // namespace prosector
