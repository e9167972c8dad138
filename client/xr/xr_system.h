#pragma once
// OpenXR instance and headset. Private to client/xr.

#include <array>
#include <vector>

#include "client/xr/xr_api.h"

namespace prosector {

/// Returns the names of the OpenXR extensions that the runtime supports. Throws XrFailure if no runtime
/// answers.
std::vector<std::string> extensions_of(const XrFunctions& xr);

class XrSystem {
 public:
  /// Creates an OpenXR instance and finds a stereo headset. `by_egl`: the renderer uses EGL rather than GLX.
  /// Throws XrFailure if the headset is temporarily unavailable, InputError if the runtime is unsuitable.
  explicit XrSystem(bool by_egl);
  ~XrSystem();
  XrSystem(const XrSystem&) = delete;
  XrSystem& operator=(const XrSystem&) = delete;

  const XrFunctions& xr() const { return xr_; }
  XrInstance instance() const { return instance_; }
  XrSystemId id() const { return id_; }
  bool tracks_hands() const { return tracks_hands_; }
  bool converts_time() const { return xr_.ConvertTimespecTimeToTimeKHR != nullptr; }
  const std::array<XrViewConfigurationView, 2>& views() const { return views_; }
  /// Returns the OpenXR mode in which the headset prefers to blend rendered frames with its view of the
  /// environment.
  XrEnvironmentBlendMode blend_mode() const { return blend_mode_; }
  /// Returns a description of the headset for the terminal: its name, its runtime, the pixels per eye, and
  /// whether it tracks hands.
  std::string description() const;

 private:
  XrFunctions xr_;
  XrInstance instance_ = XR_NULL_HANDLE;
  XrSystemId id_ = XR_NULL_SYSTEM_ID;
  bool tracks_hands_ = false;
  std::array<XrViewConfigurationView, 2> views_{};
  XrEnvironmentBlendMode blend_mode_ = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  std::string runtime_, headset_;

  void create(bool by_egl);
  void find_headset();
};

}  // namespace prosector
