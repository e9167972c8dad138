#pragma once
// Tracks head and hands of a headset's user: bare hands if detected, else controllers. Private to client/xr.

#include "client/xr/hand_joints.h"
#include "client/xr/xr_system.h"

namespace prosector {

class XrInput {
 public:
  XrInput(const XrSystem& system, XrSession session);
  ~XrInput();
  XrInput(const XrInput&) = delete;
  XrInput& operator=(const XrInput&) = delete;

  /// Updates the state of the controllers' buttons and triggers. `focused`: whether this program has the
  /// headset's input focus, without which locate() returns no hands.
  void sync(bool focused);
  /// Returns the poses of the user's head and hands at `time`, relative to the OpenXR space `base`. Hands are
  /// included only while this program has the input focus.
  TrackedUser locate(XrSpace base, XrTime time) const;

 private:
  const XrSystem& system_;
  const XrFunctions& xr_;
  XrSession session_;
  bool focused_ = false;
  XrSpace head_ = XR_NULL_HANDLE;
  XrActionSet set_ = XR_NULL_HANDLE;
  XrAction grip_ = XR_NULL_HANDLE, trigger_ = XR_NULL_HANDLE, squeeze_ = XR_NULL_HANDLE,
           menu_ = XR_NULL_HANDLE;
  std::array<XrPath, 2> hand_paths_{};
  std::array<XrSpace, 2> grips_{};
  std::array<XrHandTrackerEXT, 2> trackers_{};

  XrPath path(const char* text) const;
  XrAction make_action(const char* name, const char* shown, XrActionType type) const;
  void suggest_bindings() const;
  double value(XrAction action, std::size_t hand) const;
  bool presses_menu(std::size_t hand) const;
  std::optional<Pose> locate(XrSpace space, XrSpace base, XrTime time) const;
  std::optional<TrackedHand> bare_hand(std::size_t hand, XrSpace base, XrTime time) const;
  std::optional<TrackedHand> controller(std::size_t hand, XrSpace base, XrTime time) const;
};

}  // namespace prosector
