#include "twins/openxr/simulated_runtime.h"

#include <cstring>
#include <filesystem>
#include <iostream>
#include <limits>

#include "common/clock.h"

namespace prosector {
namespace {

constexpr double standing_eyes = 1.6;  // m, height of the local space's origin

SimulatedWearer wearer_of(const SimulatedRuntimeSettings& settings) {
  if (settings.script.empty()) return SimulatedWearer({});
  try {
    return SimulatedWearer(MotionScript::load(settings.script));
  } catch (const std::exception& error) {
    std::cerr << "openxr: " << error.what() << "\n";
    return SimulatedWearer({});
  }
}

}  // namespace

SimulatedRuntime::SimulatedRuntime() : settings(simulated_runtime_settings()), wearer(wearer_of(settings)) {}

SimulatedRuntime& simulated_runtime() {
  static SimulatedRuntime only;
  return only;
}

double SimulatedRuntime::seconds_now() const {
  return seconds(monotonic_ns());
}

void SimulatedRuntime::begin_time() {
  if (begun_ns_ == 0 && (settings.waits_for.empty() || std::filesystem::exists(settings.waits_for)))
    begun_ns_ = monotonic_ns();
}

// Each momentary fault occurs once; it is then removed from the settings.
void SimulatedRuntime::go_on() {
  begin_time();
  const double now = seconds_now();
  const auto is_due = [now](double& moment) {
    if (now < moment) return false;
    moment = Span().begin;
    return true;
  };
  if (!has_session) return;
  if (is_due(settings.session_lost)) {
    enter(XR_SESSION_STATE_LOSS_PENDING);
    session_lost = true;
  }
  if (is_due(settings.instance_lost)) {
    const auto event = typed<XrEventDataInstanceLossPending>(XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING);
    send(&event, sizeof event);
    instance_lost = true;
  }
  if (is_due(settings.left) && running) enter(XR_SESSION_STATE_STOPPING);
  if (is_due(settings.recentre_time)) {
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

void SimulatedRuntime::enter(XrSessionState next) {
  state = next;
  auto event = typed<XrEventDataSessionStateChanged>(XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED);
  event.session = reinterpret_cast<XrSession>(1);
  event.state = next;
  event.time = monotonic_ns();
  send(&event, sizeof event);
}

void SimulatedRuntime::send(const void* event, std::size_t size) {
  std::memcpy(&events.emplace_back(), event, size);
}

void SimulatedRuntime::end_session() {
  pictures.reset();
  spaces.assign(1, {});
  events.clear();
  bindings.clear();
  actions.assign(1, "");
  has_session = running = session_lost = false;
  state = XR_SESSION_STATE_UNKNOWN;
  phase = FramePhase::none;
}

std::optional<Pose> SimulatedRuntime::world(const SimulatedSpace& space, XrTime time) const {
  switch (space.kind) {
    case SimulatedSpace::Kind::head:
      return wearer.head(seconds(time)) * space.offset;
    case SimulatedSpace::Kind::stage:
      return stage_ * space.offset;
    case SimulatedSpace::Kind::local:
      return Pose{{0, standing_eyes, 0}, Quat::Identity()} * space.offset;
    case SimulatedSpace::Kind::grip:
      break;
  }
  if (!settings.controllers || !takes_focus()) return std::nullopt;
  return wearer.grip(space.hand, seconds(time)) * space.offset;
}

XrPosef SimulatedRuntime::to_xr_pose(const Pose& pose) const {
  const Eigen::Vector3f p = pose.p.cast<float>();
  const Eigen::Quaternionf q = pose.q.cast<float>();
  const float spoilt = in_garbage() ? std::numeric_limits<float>::quiet_NaN() : 0;
  return {{q.x(), q.y(), q.z(), q.w() + spoilt}, {p.x() + spoilt, p.y(), p.z()}};
}

XrResult SimulatedRuntime::client_error(const char* what, XrResult result) {
  std::cerr << "simulated OpenXR: error: " << what << std::endl;
  return result;
}

}  // namespace prosector
