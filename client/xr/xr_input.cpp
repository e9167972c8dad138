#include "client/xr/xr_input.h"
#include "common/ids.h"

#include <fmt/format.h>

#include <cstring>

namespace prosector {
namespace {

/// Bindings of the actions on one type of controller; empty: unbound.
struct Profile {
  const char *name, *trigger, *squeeze, *left_menu, *right_menu;
};
constexpr std::array<Profile, 5> profiles = {
    {{"khr/simple_controller", "select/click", "", "menu/click", "menu/click"},
     {"oculus/touch_controller", "trigger/value", "squeeze/value", "x/click", "a/click"},
     {"valve/index_controller", "trigger/value", "squeeze/value", "a/click", "a/click"},
     {"htc/vive_controller", "trigger/value", "squeeze/click", "menu/click", "menu/click"},
     {"microsoft/motion_controller", "trigger/value", "squeeze/click", "menu/click", "menu/click"}}};
constexpr std::array<const char*, 2> sides = {"/user/hand/left", "/user/hand/right"};

constexpr XrSpaceLocationFlags whole_pose =
    XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;

std::optional<Pose> valid_pose(XrSpaceLocationFlags flags, const XrPosef& pose) {
  if ((flags & whole_pose) != whole_pose) return std::nullopt;
  const Pose out = pose_of(pose);
  return is_finite(out) ? std::optional(out) : std::nullopt;
}

}  // namespace

XrInput::XrInput(const XrSystem& system, XrSession session)
    : system_(system), xr_(system.xr()), session_(session) {
  auto eyes = typed<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
  eyes.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_VIEW;
  eyes.poseInReferenceSpace = xr_identity;
  PROSECTOR_XR_CHECK(xr_, CreateReferenceSpace, session_, &eyes, &head_);
  for (std::size_t hand : {left_hand, right_hand}) hand_paths_[hand] = path(sides[hand]);
  auto info = typed<XrActionSetCreateInfo>(XR_TYPE_ACTION_SET_CREATE_INFO);
  std::strcpy(info.actionSetName, "dissecting");
  std::strcpy(info.localizedActionSetName, "Dissecting");
  PROSECTOR_XR_CHECK(xr_, CreateActionSet, system_.instance(), &info, &set_);
  grip_ = make_action("hand", "Hand", XR_ACTION_TYPE_POSE_INPUT);
  trigger_ = make_action("grasp", "Grasp", XR_ACTION_TYPE_FLOAT_INPUT);
  squeeze_ = make_action("point", "Point", XR_ACTION_TYPE_FLOAT_INPUT);
  menu_ = make_action("menu", "Menu", XR_ACTION_TYPE_BOOLEAN_INPUT);
  suggest_bindings();
  auto attach = typed<XrSessionActionSetsAttachInfo>(XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
  attach.countActionSets = 1;
  attach.actionSets = &set_;
  PROSECTOR_XR_CHECK(xr_, AttachSessionActionSets, session_, &attach);
  for (std::size_t hand : {left_hand, right_hand}) {
    auto space = typed<XrActionSpaceCreateInfo>(XR_TYPE_ACTION_SPACE_CREATE_INFO);
    space.action = grip_;
    space.subactionPath = hand_paths_[hand];
    space.poseInActionSpace = xr_identity;
    PROSECTOR_XR_CHECK(xr_, CreateActionSpace, session_, &space, &grips_[hand]);
    if (!system_.tracks_hands()) continue;
    auto tracker = typed<XrHandTrackerCreateInfoEXT>(XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT);
    tracker.hand = hand == left_hand ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT;
    tracker.handJointSet = XR_HAND_JOINT_SET_DEFAULT_EXT;
    PROSECTOR_XR_CHECK(xr_, CreateHandTrackerEXT, session_, &tracker, &trackers_[hand]);
  }
}

// Destroying the session also destroys its objects, including hand trackers.
XrInput::~XrInput() {
  if (set_ != XR_NULL_HANDLE) xr_.DestroyActionSet(set_);
}

XrPath XrInput::path(const char* text) const {
  XrPath out = XR_NULL_PATH;
  PROSECTOR_XR_CHECK(xr_, StringToPath, system_.instance(), text, &out);
  return out;
}

XrAction XrInput::make_action(const char* name, const char* shown, XrActionType type) const {
  auto info = typed<XrActionCreateInfo>(XR_TYPE_ACTION_CREATE_INFO);
  info.actionType = type;
  std::strcpy(info.actionName, name);
  std::strcpy(info.localizedActionName, shown);
  info.countSubactionPaths = 2;
  info.subactionPaths = hand_paths_.data();
  XrAction out = XR_NULL_HANDLE;
  PROSECTOR_XR_CHECK(xr_, CreateAction, set_, &info, &out);
  return out;
}

void XrInput::suggest_bindings() const {
  for (const Profile& profile : profiles) {
    std::vector<XrActionSuggestedBinding> bindings;
    for (std::size_t hand : {left_hand, right_hand}) {
      const auto bind = [&](XrAction action, const char* input) {
        if (*input != '\0')
          bindings.push_back({action, path(fmt::format("{}/input/{}", sides[hand], input).c_str())});
      };
      bind(grip_, "grip/pose");
      bind(trigger_, profile.trigger);
      bind(squeeze_, profile.squeeze);
      bind(menu_, hand == left_hand ? profile.left_menu : profile.right_menu);
    }
    auto info = typed<XrInteractionProfileSuggestedBinding>(XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    info.interactionProfile = path(fmt::format("/interaction_profiles/{}", profile.name).c_str());
    info.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
    info.suggestedBindings = bindings.data();
    // A runtime may not support a controller type: then it has no such controllers.
    const XrResult result = xr_.SuggestInteractionProfileBindings(system_.instance(), &info);
    if (result != XR_ERROR_PATH_UNSUPPORTED) check_xr("xrSuggestInteractionProfileBindings", result);
  }
}

void XrInput::sync(bool focused) {
  const XrActiveActionSet active{set_, XR_NULL_PATH};
  auto info = typed<XrActionsSyncInfo>(XR_TYPE_ACTIONS_SYNC_INFO);
  info.countActiveActionSets = 1;
  info.activeActionSets = &active;
  const XrResult result = xr_.SyncActions(session_, &info);
  check_xr("xrSyncActions", result);
  focused_ = focused && result != XR_SESSION_NOT_FOCUSED;
}

TrackedUser XrInput::locate(XrSpace base, XrTime time) const {
  TrackedUser out;
  out.head = locate(head_, base, time);
  if (!focused_) return out;
  for (std::size_t hand : {left_hand, right_hand}) {
    out.hands[hand] = bare_hand(hand, base, time);
    if (!out.hands[hand]) out.hands[hand] = controller(hand, base, time);
    if (out.hands[hand] && presses_menu(hand)) out.hands[hand]->buttons |= menu_button;
  }
  return out;
}

std::optional<Pose> XrInput::locate(XrSpace space, XrSpace base, XrTime time) const {
  auto location = typed<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
  PROSECTOR_XR_CHECK(xr_, LocateSpace, space, base, time, &location);
  return valid_pose(location.locationFlags, location.pose);
}

std::optional<TrackedHand> XrInput::bare_hand(std::size_t hand, XrSpace base, XrTime time) const {
  if (trackers_[hand] == XR_NULL_HANDLE) return std::nullopt;
  std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT> seen{};
  auto out = typed<XrHandJointLocationsEXT>(XR_TYPE_HAND_JOINT_LOCATIONS_EXT);
  out.jointCount = XR_HAND_JOINT_COUNT_EXT;
  out.jointLocations = seen.data();
  auto wish = typed<XrHandJointsLocateInfoEXT>(XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT);
  wish.baseSpace = base;
  wish.time = time;
  PROSECTOR_XR_CHECK(xr_, LocateHandJointsEXT, trackers_[hand], &wish, &out);
  if (out.isActive != XR_TRUE) return std::nullopt;
  HeadsetJoints joints;
  static_assert(headset_joints == XR_HAND_JOINT_COUNT_EXT);
  for (std::size_t k = 0; k < headset_joints; ++k) {
    const auto pose = valid_pose(seen[k].locationFlags, seen[k].pose);
    if (!pose) return std::nullopt;
    joints[k] = *pose;
  }
  return hand_of_joints(joints);
}

double XrInput::value(XrAction action, std::size_t hand) const {
  auto wish = typed<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
  wish.action = action;
  wish.subactionPath = hand_paths_[hand];
  auto state = typed<XrActionStateFloat>(XR_TYPE_ACTION_STATE_FLOAT);
  PROSECTOR_XR_CHECK(xr_, GetActionStateFloat, session_, &wish, &state);
  return state.isActive == XR_TRUE ? state.currentState : 0;
}

// Also applies to hands with joints: some runtimes synthesise the joints from the controller in the hand.
bool XrInput::presses_menu(std::size_t hand) const {
  auto wish = typed<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
  wish.action = menu_;
  wish.subactionPath = hand_paths_[hand];
  auto menu = typed<XrActionStateBoolean>(XR_TYPE_ACTION_STATE_BOOLEAN);
  PROSECTOR_XR_CHECK(xr_, GetActionStateBoolean, session_, &wish, &menu);
  return menu.isActive == XR_TRUE && menu.currentState == XR_TRUE;
}

std::optional<TrackedHand> XrInput::controller(std::size_t hand, XrSpace base, XrTime time) const {
  const auto grip = locate(grips_[hand], base, time);
  if (!grip) return std::nullopt;
  return hand_of_controller(hand, {*grip, value(trigger_, hand), value(squeeze_, hand)});
}

}  // namespace prosector
