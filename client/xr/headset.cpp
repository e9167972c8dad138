#include "client/xr/headset.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "client/xr/xr_session.h"
#include "common/clock.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::int64_t retry_ns = 500'000'000;
constexpr std::chrono::milliseconds follow_interval(8);

/// Returns the context if an OpenXR runtime can render with it, else throws InputError.
const GlContext& shared(const GlContext& context) {
  if (!std::holds_alternative<std::monostate>(context.handles())) return context;
  throw InputError("--display openxr needs an OpenGL context by EGL: install libegl1");
}

}  // namespace

bool headset_takes_egl() {
  try {
    const std::vector<std::string> offered = extensions_of(load_openxr());
    return std::ranges::find(offered, XR_MNDX_EGL_ENABLE_EXTENSION_NAME) != offered.end();
  } catch (const XrFailure&) {
    return true;
  }
}

struct Headset::Parts {
  Parts(const GlContext& context, std::function<void(const std::string&)> report)
      : system(std::holds_alternative<EglHandles>(context.handles())),
        run(system, context, std::move(report)) {}
  XrSystem system;
  HeadsetSession run;
};

Headset::Headset(const GlContext& context, const Pose& room_stage,
                 std::function<void(const TrackedUser& user)> take_user)
    : context_(shared(context)), room_stage_(room_stage), take_user_(std::move(take_user)) {
  try {
    connect();
  } catch (const XrFailure& failure) {
    if (failure.result != XR_ERROR_FORM_FACTOR_UNAVAILABLE)
      throw InputError(
          fmt::format("--display openxr: {}; start the headset's runtime, and make it the active one "
                      "(XR_RUNTIME_JSON, or active_runtime.json in ~/.config/openxr/1 or /etc/xdg/openxr/1)",
                      failure.what()));
    lose(failure.what());
  }
  follower_ = std::jthread([this](std::stop_token stop) {
    for (; !stop.stop_requested(); std::this_thread::sleep_for(follow_interval)) follow_user();
  });
}

Headset::~Headset() {
  follower_.request_stop();
  follower_.join();
}

/// Reports the user's current poses. Failures of the runtime are handled by the render thread.
void Headset::follow_user() {
  TrackedUser user;
  {
    const std::lock_guard lock(mutex_);
    if (!parts_ || !parts_->run.has_user()) return;
    try {
      user = in_room(parts_->run.user_now());
    } catch (const XrFailure&) {
      return;
    }
  }
  user.time_ns = monotonic_ns();
  take_user_(user);
}

void Headset::connect() {
  tried_ns_ = monotonic_ns();
  auto parts = std::make_unique<Parts>(context_, [this](const std::string& line) {
    news_.push_back({line, true});
  });
  {
    const std::lock_guard lock(mutex_);
    parts_ = std::move(parts);
  }
  news_.push_back({fmt::format("headset: {}", parts_->system.description())});
  reason_.clear();
}

void Headset::lose(const std::string& why) {
  {
    const std::lock_guard lock(mutex_);
    parts_.reset();
  }
  keeps_time_ = false;
  pacing_.pause();
  if (why != reason_) news_.push_back({fmt::format("headset: {}; waiting for it", why)});
  reason_ = why;
}

std::optional<HeadsetFrame> Headset::next_frame() {
  keeps_time_ = false;
  try {
    if (!parts_ && monotonic_ns() - tried_ns_ >= retry_ns) connect();
    return parts_ ? frame() : std::nullopt;
  } catch (const XrFailure& failure) {
    lose(failure.what());
  } catch (const InputError& error) {
    lose(error.what());
  }
  return std::nullopt;
}

std::optional<HeadsetFrame> Headset::frame() {
  HeadsetSession& run = parts_->run;
  {
    const std::lock_guard lock(mutex_);
    run.follow_events();
  }
  closed_ = run.over();
  if (!run.running()) {
    pacing_.pause();
    return std::nullopt;
  }
  const bool seen = run.wait();
  pacing_.take(monotonic_ns(), run.seen_ns(), run.period_ns());
  keeps_time_ = true;
  {
    const std::lock_guard lock(mutex_);
    run.sync();
  }
  const auto eyes = seen ? run.eyes() : std::nullopt;
  if (!eyes) {
    run.end_without_image();
    return std::nullopt;
  }
  HeadsetFrame out{*eyes, run.eye_width(), run.eye_height(), in_room(run.user_at_display())};
  for (EyeView& eye : out.eyes) eye.pose = room_stage_ * eye.pose;
  return out;
}

void Headset::show(const std::function<void(unsigned texture)>& draw) {
  try {
    parts_->run.end(draw);
  } catch (const XrFailure& failure) {
    lose(failure.what());
  }
}

TrackedUser Headset::in_room(TrackedUser user) const {
  if (user.head) user.head = room_stage_ * *user.head;
  for (auto& hand : user.hands)
    if (hand) hand->wrist = room_stage_ * hand->wrist;
  return user;
}

}  // namespace prosector
