#pragma once
// A small OpenXR runtime of our own, by the public specification: what the client calls, and faults. One
// instance with one session at a time. What a client does wrong is told on standard error: "openxr: WRONG:
// …".

#define EGL_NO_PLATFORM_SPECIFIC_TYPES
#include <EGL/egl.h>
#include <time.h>

#define XR_NO_PROTOTYPES
#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_EGL
#define XR_USE_PLATFORM_XLIB
#define XR_USE_TIMESPEC
// X11's types by name, so that none of its headers is needed.
using Display = struct _XDisplay;
using GLXFBConfig = struct __GLXFBConfigRec*;
using GLXContext = struct __GLXcontextRec*;
using GLXDrawable = unsigned long;

#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "drivers/twins/headset_wearer.h"
#include "drivers/twins/openxr/double_pictures.h"
#include "drivers/twins/openxr/double_settings.h"

namespace prosector {

/// A place that moves or stays: what a client locates.
struct DoubleSpace {
  enum class Kind : std::uint8_t { head, stage, local, grip } kind = Kind::stage;
  std::size_t hand = right_hand;
  Pose offset;
};

/// What of a frame the client has done.
enum class FramePhase : std::uint8_t { none, waited, begun };

class DoubleRuntime {
 public:
  DoubleRuntime();

  std::recursive_mutex mutex;
  DoubleSettings settings;
  HeadsetWearer wearer;

  // An instance has:
  bool has_instance = false, instance_lost = false;
  std::vector<std::string> paths = {""};                                  // by XrPath
  std::vector<std::string> actions = {""};                                // names, by XrAction
  std::map<std::pair<std::uint64_t, std::size_t>, std::string> bindings;  // action, hand: of what is held
  std::deque<XrEventDataBuffer> events;

  // A session has:
  bool has_session = false, running = false, session_lost = false;
  XrSessionState state = XR_SESSION_STATE_UNKNOWN;
  std::vector<DoubleSpace> spaces = {{}};  // by XrSpace
  std::optional<DoublePictures> pictures;
  PFNEGLGETPROCADDRESSPROC get_proc = nullptr;
  FramePhase phase = FramePhase::none;
  XrTime shown_ns = 0;

  /// Returns the time since the wearer goes on, s; below 0 before.
  double seconds(XrTime time) const {
    return begun_ns_ == 0 ? -1 : 1e-9 * static_cast<double>(time - begun_ns_);
  }
  double seconds_now() const;
  /// Lets the wearer go on, once there is what they wait for.
  void begin_time();
  /// Does what the settings have for now.
  void go_on();
  void enter(XrSessionState next);
  void send(const void* event, std::size_t size);
  void end_session();
  bool in_garbage() const { return settings.garbage.holds(seconds_now()); }
  /// Returns where a space is in the world, or nothing where it isn't known.
  std::optional<Pose> world(const DoubleSpace& space, XrTime time) const;
  /// Returns a pose as the client gets it, which may be garbage.
  XrPosef told(const Pose& pose) const;
  /// Says what the client does wrong, and returns the result that it gets.
  static XrResult wrong(const char* what, XrResult result);
  bool takes_focus() const { return state == XR_SESSION_STATE_FOCUSED; }

 private:
  std::int64_t begun_ns_ = 0;
  Pose stage_;
};

/// Returns the one runtime of this library.
DoubleRuntime& double_runtime();

/// Returns the function of that name, or null.
PFN_xrVoidFunction instance_function(const std::string& name);
PFN_xrVoidFunction session_function(const std::string& name);
PFN_xrVoidFunction frame_function(const std::string& name);
PFN_xrVoidFunction input_function(const std::string& name);

/// Locks the runtime, and returns what `does` does with it.
template <class Does>
XrResult with_runtime(Does does) {
  DoubleRuntime& runtime = double_runtime();
  const std::lock_guard lock(runtime.mutex);
  runtime.go_on();
  if (runtime.instance_lost) return XR_ERROR_INSTANCE_LOST;
  return does(runtime);
}
/// Does the same for functions of a session, which may be lost.
template <class Does>
XrResult with_session(Does does) {
  return with_runtime([&](DoubleRuntime& r) { return r.session_lost ? XR_ERROR_SESSION_LOST : does(r); });
}

/// Returns a structure of that type, which is zero but for it.
template <class T>
T typed(XrStructureType type) {
  T out{};
  out.type = type;
  return out;
}

/// Fills in a list as OpenXR's enumerating functions do.
template <class T, class Fill>
XrResult enumerate(std::uint32_t capacity, std::uint32_t* count, T* out, std::uint32_t size, Fill fill) {
  *count = size;
  if (capacity == 0) return XR_SUCCESS;
  if (capacity < size) return XR_ERROR_SIZE_INSUFFICIENT;
  for (std::uint32_t k = 0; k < size; ++k) fill(k, out[k]);
  return XR_SUCCESS;
}

}  // namespace prosector
