#pragma once
// A small simulated OpenXR runtime after the public specification: the functions that the client calls, and
// faults. It supports one instance with one session at a time. Client errors are reported on standard error:
// "simulated OpenXR: error: …".

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

/// An OpenXR space that a client of the simulated runtime can locate: a reference space (head, stage, local),
/// or a hand's grip.
struct SimulatedSpace {
  enum class Kind : std::uint8_t { head, stage, local, grip } kind = Kind::stage;
  std::size_t hand = right_hand;
  Pose offset;
};

/// Progress of the client's current frame: none, after xrWaitFrame, or after xrBeginFrame.
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

  /// Returns the time in s from the start of the simulated wearer's motion to `time`; −1 if the motion has
  /// not started.
  double seconds(XrTime time) const {
    return begun_ns_ == 0 ? -1 : 1e-9 * static_cast<double>(time - begun_ns_);
  }
  double seconds_now() const;
  /// Starts the simulated wearer's motion if it has not started yet, unless the settings name a file to wait
  /// for that does not exist yet.
  void begin_time();
  /// Applies the simulated faults and the session's state changes that are due now.
  void go_on();
  void enter(XrSessionState next);
  void send(const void* event, std::size_t size);
  void end_session();
  bool in_garbage() const { return settings.garbage.holds(seconds_now()); }
  /// Returns the pose of an OpenXR space in the world frame at `time`. Returns nothing for the grip of a
  /// controller that is not tracked.
  std::optional<Pose> world(const SimulatedSpace& space, XrTime time) const;
  /// Converts a pose to the one that the client receives, with NaN numbers while the simulated fault
  /// `garbage` lasts.
  XrPosef to_xr_pose(const Pose& pose) const;
  /// Prints the client's error `what` on standard error and returns `result`, the error code for the client.
  static XrResult client_error(const char* what, XrResult result);
  bool takes_focus() const { return state == XR_SESSION_STATE_FOCUSED; }

 private:
  std::int64_t begun_ns_ = 0;
  Pose stage_;
};

/// Returns the only simulated OpenXR runtime of this library; the first call creates it.
SimulatedRuntime& simulated_runtime();

/// Returns the OpenXR function of that name among those that concern instances, or null. Separate functions
/// look up those that concern sessions, frames and input.
PFN_xrVoidFunction instance_function(const std::string& name);
PFN_xrVoidFunction session_function(const std::string& name);
PFN_xrVoidFunction frame_function(const std::string& name);
PFN_xrVoidFunction input_function(const std::string& name);

/// Calls `does` with the locked simulated runtime, after applying the faults that are due, and returns its
/// result. Returns XR_ERROR_INSTANCE_LOST instead if the simulated instance is lost.
template <class Does>
XrResult with_runtime(Does does) {
  SimulatedRuntime& runtime = simulated_runtime();
  const std::lock_guard lock(runtime.mutex);
  runtime.go_on();
  if (runtime.instance_lost) return XR_ERROR_INSTANCE_LOST;
  return does(runtime);
}
/// Calls `does` with the locked simulated runtime and returns its result. Returns XR_ERROR_SESSION_LOST
/// instead if the simulated session is lost.
template <class Does>
XrResult with_session(Does does) {
  return with_runtime([&](SimulatedRuntime& r) { return r.session_lost ? XR_ERROR_SESSION_LOST : does(r); });
}

/// Returns a zero-initialised OpenXR structure with its `type` set.
template <class T>
T typed(XrStructureType type) {
  T out{};
  out.type = type;
  return out;
}

/// Implements the two-call convention of OpenXR's enumeration functions. Stores the number of items, `size`,
/// in `count`. If `capacity` is not 0, it also fills `out` by fill(index, item), or returns
/// XR_ERROR_SIZE_INSUFFICIENT if `capacity` is too small.
template <class T, class Fill>
XrResult enumerate(std::uint32_t capacity, std::uint32_t* count, T* out, std::uint32_t size, Fill fill) {
  *count = size;
  if (capacity == 0) return XR_SUCCESS;
  if (capacity < size) return XR_ERROR_SIZE_INSUFFICIENT;
  for (std::uint32_t k = 0; k < size; ++k) fill(k, out[k]);
  return XR_SUCCESS;
}

}  // namespace prosector
