#include "drivers/twins/openxr/double_runtime.h"

#include <cstring>
#include <filesystem>
#include <iostream>
#include <limits>

#include "common/clock.h"

namespace prosector {
namespace {

constexpr double standing_eyes = 1.6;  // m, of the local space

HeadsetWearer wearer_of(const DoubleSettings& settings) {
  if (settings.script.empty()) return HeadsetWearer({});
  try {
    return HeadsetWearer(MotionScript::load(settings.script));
  } catch (const std::exception& error) {
    std::cerr << "openxr: " << error.what() << "\n";
    return HeadsetWearer({});
  }
}

}  // namespace

DoubleRuntime::DoubleRuntime() : settings(settings_of_double()), wearer(wearer_of(settings)) {}

DoubleRuntime& double_runtime() {
  static DoubleRuntime only;
  return only;
}

double DoubleRuntime::seconds_now() const {
  return seconds(monotonic_ns());
}

void DoubleRuntime::begin_time() {
  if (begun_ns_ == 0 && (settings.waits_for.empty() || std::filesystem::exists(settings.waits_for)))
    begun_ns_ = monotonic_ns();
}

// Each fault of a moment happens once: it is taken out of the settings.
void DoubleRuntime::go_on() {
  begin_time();
  const double now = seconds_now();
  const auto comes = [now](double& moment) {
    if (now < moment) return false;
    moment = Span().begin;
    return true;
  };
  if (!has_session) return;
  if (comes(settings.session_lost)) {
    enter(XR_SESSION_STATE_LOSS_PENDING);
    session_lost = true;
  }
  if (comes(settings.instance_lost)) {
    const auto event = typed<XrEventDataInstanceLossPending>(XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING);
    send(&event, sizeof event);
    instance_lost = true;
  }
  if (comes(settings.left) && running) enter(XR_SESSION_STATE_STOPPING);
  if (comes(settings.centred_anew)) {
    auto event =
        typed<XrEventDataReferenceSpaceChangePending>(XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING);
    event.session = reinterpret_cast<XrSession>(1);
    event.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_STAGE;
    send(&event, sizeof event);
    stage_.p.x() = 0.1;
  }
  if (state == XR_SESSION_STATE_FOCUSED && settings.unfocused.holds(now)) enter(XR_SESSION_STATE_VISIBLE);
  if (state == XR_SESSION_STATE_VISIBLE && now >= settings.unfocused.end) enter(XR_SESSION_STATE_FOCUSED);
}

void DoubleRuntime::enter(XrSessionState next) {
  state = next;
  auto event = typed<XrEventDataSessionStateChanged>(XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED);
  event.session = reinterpret_cast<XrSession>(1);
  event.state = next;
  event.time = monotonic_ns();
  send(&event, sizeof event);
}

void DoubleRuntime::send(const void* event, std::size_t size) {
  std::memcpy(&events.emplace_back(), event, size);
}

void DoubleRuntime::end_session() {
  pictures.reset();
  spaces.assign(1, {});
  events.clear();
  bindings.clear();
  actions.assign(1, "");
  has_session = running = session_lost = false;
  state = XR_SESSION_STATE_UNKNOWN;
  phase = FramePhase::none;
}

std::optional<Pose> DoubleRuntime::world(const DoubleSpace& space, XrTime time) const {
  switch (space.kind) {
    case DoubleSpace::Kind::head:
      return wearer.head(seconds(time)) * space.offset;
    case DoubleSpace::Kind::stage:
      return stage_ * space.offset;
    case DoubleSpace::Kind::local:
      return Pose{{0, standing_eyes, 0}, Quat::Identity()} * space.offset;
    case DoubleSpace::Kind::grip:
      break;
  }
  if (!settings.controllers || !takes_focus()) return std::nullopt;
  return wearer.grip(space.hand, seconds(time)) * space.offset;
}

XrPosef DoubleRuntime::told(const Pose& pose) const {
  const Eigen::Vector3f p = pose.p.cast<float>();
  const Eigen::Quaternionf q = pose.q.cast<float>();
  const float spoilt = in_garbage() ? std::numeric_limits<float>::quiet_NaN() : 0;
  return {{q.x(), q.y(), q.z(), q.w() + spoilt}, {p.x() + spoilt, p.y(), p.z()}};
}

XrResult DoubleRuntime::wrong(const char* what, XrResult result) {
  std::cerr << "openxr: WRONG: " << what << std::endl;
  return result;
}

}  // namespace prosector
