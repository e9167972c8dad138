#pragma once
// A small simulated OpenXR runtime after the public specification: the functions that the client calls, and
// faults. It supports one instance with one session at a time. Client errors are reported on standard error:
// "openxr: WRONG: …".

#define EGL_NO_PLATFORM_SPECIFIC_TYPES
#include <EGL/egl.h>
#include <time.h>

#define XR_NO_PROTOTYPES
#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_EGL
#define XR_USE_PLATFORM_XLIB
#define XR_USE_TIMESPEC
// X11's types as forward declarations, so that its headers are not needed.
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

#include "common/ids.h"

#include "twins/openxr/simulated_settings.h"
#include "twins/openxr/simulated_swapchain.h"
#include "twins/trackers/simulated_wearer.h"

namespace prosector {

/// A reference or action space that a client can locate.
struct SimulatedSpace {
  enum class Kind : std::uint8_t { head, stage, local, grip } kind = Kind::stage;
  std::size_t hand = right_hand;
  Pose offset;
};

/// Progress of the client's current frame.
enum class FramePhase : std::uint8_t { none, waited, begun };

class SimulatedRuntime {
 public:
  SimulatedRuntime();

  std::recursive_mutex mutex;
  SimulatedRuntimeSettings settings;
  SimulatedWearer wearer;

  // State of an instance:
  bool has_instance = false, instance_lost = false;
  std::vector<std::string> paths = {""};                                  // indexed by XrPath
  std::vector<std::string> actions = {""};                                // names, indexed by XrAction
  std::map<std::pair<std::uint64_t, std::size_t>, std::string> bindings;  // (action, hand) to the input path
                                                                          // of the held controller
  std::deque<XrEventDataBuffer> events;

  // State of a session:
  bool has_session = false, running = false, session_lost = false;
  XrSessionState state = XR_SESSION_STATE_UNKNOWN;
  std::vector<SimulatedSpace> spaces = {{}};  // indexed by XrSpace
  std::optional<SimulatedSwapchain> pictures;
  PFNEGLGETPROCADDRESSPROC get_proc = nullptr;
  FramePhase phase = FramePhase::none;
  XrTime shown_ns = 0;

  /// Returns the time since the wearer's motion began, s; −1 if it has not begun.
  double seconds(XrTime time) const {
    return begun_ns_ == 0 ? -1 : 1e-9 * static_cast<double>(time - begun_ns_);
  }
  double seconds_now() const;
  /// Starts the wearer's motion, unless it waits for a file that does not exist yet.
  void begin_time();
  /// Applies the faults and state changes that are due.
  void go_on();
  void enter(XrSessionState next);
  void send(const void* event, std::size_t size);
  void end_session();
  bool in_garbage() const { return settings.garbage.holds(seconds_now()); }
  /// Returns the pose of a space in the world frame, or nothing if it is unknown.
  std::optional<Pose> world(const SimulatedSpace& space, XrTime time) const;
  /// Returns a pose as reported to the client, which may be garbage.
  XrPosef told(const Pose& pose) const;
  /// Reports a client error on standard error and returns `result`.
  static XrResult wrong(const char* what, XrResult result);
  bool takes_focus() const { return state == XR_SESSION_STATE_FOCUSED; }

 private:
  std::int64_t begun_ns_ = 0;
  Pose stage_;
};

/// Returns the library's only runtime.
SimulatedRuntime& simulated_runtime();

/// Returns the function of that name, or null. There is one look-up per group of functions.
PFN_xrVoidFunction instance_function(const std::string& name);
PFN_xrVoidFunction session_function(const std::string& name);
PFN_xrVoidFunction frame_function(const std::string& name);
PFN_xrVoidFunction input_function(const std::string& name);

/// Calls `does` with the locked runtime and returns its result.
template <class Does>
XrResult with_runtime(Does does) {
  SimulatedRuntime& runtime = simulated_runtime();
  const std::lock_guard lock(runtime.mutex);
  runtime.go_on();
  if (runtime.instance_lost) return XR_ERROR_INSTANCE_LOST;
  return does(runtime);
}
/// Calls `does` like with_runtime(), unless the session is lost.
template <class Does>
XrResult with_session(Does does) {
  return with_runtime([&](SimulatedRuntime& r) { return r.session_lost ? XR_ERROR_SESSION_LOST : does(r); });
}

/// Returns a zero-initialised structure with its `type` set.
template <class T>
T typed(XrStructureType type) {
  T out{};
  out.type = type;
  return out;
}

/// Fills a list in the way of OpenXR's enumeration functions.
template <class T, class Fill>
XrResult enumerate(std::uint32_t capacity, std::uint32_t* count, T* out, std::uint32_t size, Fill fill) {
  *count = size;
  if (capacity == 0) return XR_SUCCESS;
  if (capacity < size) return XR_ERROR_SIZE_INSUFFICIENT;
  for (std::uint32_t k = 0; k < size; ++k) fill(k, out[k]);
  return XR_SUCCESS;
}

}  // namespace prosector
