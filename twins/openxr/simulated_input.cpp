// Controllers of the simulated OpenXR runtime. The wearer's index finger pulls the trigger, the middle finger
// squeezes, the ring finger presses A or X. The simulated controller is an "oculus/touch_controller";
// Microsoft's is unsupported.

#include "twins/openxr/simulated_runtime.h"

namespace prosector {
namespace {

constexpr const char *held_kind = "/interaction_profiles/oculus/touch_controller",
                     *unknown_kind = "/interaction_profiles/microsoft/motion_controller";

XrResult XRAPI_CALL create_action_set(XrInstance, const XrActionSetCreateInfo*, XrActionSet* out) {
  *out = reinterpret_cast<XrActionSet>(1);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_action_set(XrActionSet) {
  return XR_SUCCESS;
}

XrResult XRAPI_CALL create_action(XrActionSet, const XrActionCreateInfo* info, XrAction* out) {
  return with_runtime([&](SimulatedRuntime& r) {
    *out = reinterpret_cast<XrAction>(r.actions.size());
    r.actions.emplace_back(info->actionName);
    return XR_SUCCESS;
  });
}

std::size_t hand_of(const std::string& path) {
  return path.starts_with("/user/hand/left") ? left_hand : right_hand;
}

XrResult XRAPI_CALL suggest_bindings(XrInstance, const XrInteractionProfileSuggestedBinding* info) {
  return with_runtime([&](SimulatedRuntime& r) {
    const std::string& kind = r.paths.at(info->interactionProfile);
    if (kind == unknown_kind) return XR_ERROR_PATH_UNSUPPORTED;
    if (kind != held_kind) return XR_SUCCESS;
    for (std::uint32_t k = 0; k < info->countSuggestedBindings; ++k) {
      const XrActionSuggestedBinding& binding = info->suggestedBindings[k];
      const std::string& path = r.paths.at(binding.binding);
      r.bindings[{reinterpret_cast<std::uint64_t>(binding.action), hand_of(path)}] =
          path.substr(path.find("/input/"));
    }
    return XR_SUCCESS;
  });
}

XrResult XRAPI_CALL attach(XrSession, const XrSessionActionSetsAttachInfo*) {
  return with_session([&](SimulatedRuntime& r) {
    return r.bindings.empty() ? SimulatedRuntime::client_error(
                                    "xrAttachSessionActionSets was called without suggested bindings",
                                    XR_ERROR_VALIDATION_FAILURE)
                              : XR_SUCCESS;
  });
}

XrResult XRAPI_CALL sync(XrSession, const XrActionsSyncInfo*) {
  return with_session(
      [&](SimulatedRuntime& r) { return r.takes_focus() ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED; });
}

/// Returns how far the input of an action is pressed, 0 … 1; nullopt if it is not bound or inactive.
std::optional<double> pressed(const SimulatedRuntime& r, const XrActionStateGetInfo& info) {
  const std::size_t hand = hand_of(r.paths.at(info.subactionPath));
  const auto bound = r.bindings.find({reinterpret_cast<std::uint64_t>(info.action), hand});
  const bool there = r.settings.controllers || r.settings.held;
  if (bound == r.bindings.end() || !there || !r.takes_focus()) return std::nullopt;
  const auto flexion = r.wearer.flexion(hand, r.seconds_now());
  if (bound->second == "/input/trigger/value") return flexion[1];
  if (bound->second == "/input/squeeze/value") return flexion[2];
  return flexion[3];  // a button
}

XrResult XRAPI_CALL float_state(XrSession, const XrActionStateGetInfo* info, XrActionStateFloat* out) {
  return with_session([&](SimulatedRuntime& r) {
    const auto value = pressed(r, *info);
    out->isActive = value ? XR_TRUE : XR_FALSE;
    out->currentState = static_cast<float>(value.value_or(0));
    return XR_SUCCESS;
  });
}

XrResult XRAPI_CALL boolean_state(XrSession, const XrActionStateGetInfo* info, XrActionStateBoolean* out) {
  return with_session([&](SimulatedRuntime& r) {
    const auto value = pressed(r, *info);
    out->isActive = value ? XR_TRUE : XR_FALSE;
    out->currentState = value.value_or(0) > 0.5 ? XR_TRUE : XR_FALSE;
    return XR_SUCCESS;
  });
}

}  // namespace

PFN_xrVoidFunction input_function(const std::string& name) {
  static const std::map<std::string, PFN_xrVoidFunction> table = {
      {"xrCreateActionSet", reinterpret_cast<PFN_xrVoidFunction>(create_action_set)},
      {"xrDestroyActionSet", reinterpret_cast<PFN_xrVoidFunction>(destroy_action_set)},
      {"xrCreateAction", reinterpret_cast<PFN_xrVoidFunction>(create_action)},
      {"xrSuggestInteractionProfileBindings", reinterpret_cast<PFN_xrVoidFunction>(suggest_bindings)},
      {"xrAttachSessionActionSets", reinterpret_cast<PFN_xrVoidFunction>(attach)},
      {"xrSyncActions", reinterpret_cast<PFN_xrVoidFunction>(sync)},
      {"xrGetActionStateFloat", reinterpret_cast<PFN_xrVoidFunction>(float_state)},
      {"xrGetActionStateBoolean", reinterpret_cast<PFN_xrVoidFunction>(boolean_state)}};
  const auto found = table.find(name);
  return found == table.end() ? nullptr : found->second;
}

}  // namespace prosector
