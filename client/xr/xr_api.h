#pragma once
// Functions of OpenXR, loaded at runtime when a headset is requested. Private to client/xr.

#define EGL_NO_PLATFORM_SPECIFIC_TYPES
#include <EGL/egl.h>
#include <time.h>

// Forward declarations of X11's types, so that its headers are not needed.
using Display = struct _XDisplay;
using GLXFBConfig = struct __GLXFBConfigRec*;
using GLXContext = struct __GLXcontextRec*;
using GLXDrawable = unsigned long;

#define XR_NO_PROTOTYPES
#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_EGL
#define XR_USE_PLATFORM_XLIB
#define XR_USE_TIMESPEC
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <stdexcept>
#include <string>

#include "common/math.h"

// clang-format off
#define PROSECTOR_XR_FUNCTIONS(X) \
  X(AcquireSwapchainImage) X(AttachSessionActionSets) X(BeginFrame) X(BeginSession) X(CreateAction)       \
  X(CreateActionSet) X(CreateActionSpace) X(CreateReferenceSpace) X(CreateSession) X(CreateSwapchain)     \
  X(DestroyActionSet) X(DestroyInstance) X(DestroySession) X(DestroySpace) X(DestroySwapchain)            \
  X(EndFrame) X(EndSession) X(EnumerateEnvironmentBlendModes) X(EnumerateReferenceSpaces) X(EnumerateSwapchainFormats)                      \
  X(EnumerateSwapchainImages) X(EnumerateViewConfigurationViews) X(GetActionStateBoolean)                 \
  X(GetActionStateFloat) X(GetInstanceProperties) X(GetSystem) X(GetSystemProperties)                     \
  X(LocateSpace) X(LocateViews) X(PollEvent) X(ReleaseSwapchainImage) X(StringToPath)                     \
  X(SuggestInteractionProfileBindings) X(SyncActions) X(WaitFrame) X(WaitSwapchainImage)
#define PROSECTOR_XR_GRAPHICS(X) X(GetOpenGLGraphicsRequirementsKHR)
#define PROSECTOR_XR_HANDS(X) X(CreateHandTrackerEXT) X(LocateHandJointsEXT)
#define PROSECTOR_XR_TIME(X) X(ConvertTimespecTimeToTimeKHR)
// clang-format on

namespace prosector {

/// Function pointers of OpenXR, named without the prefix: xr.WaitFrame(…) calls xrWaitFrame(…). Functions of
/// an extension are null if the runtime lacks the extension.
struct XrFunctions {
  PFN_xrGetInstanceProcAddr GetInstanceProcAddr = nullptr;
  PFN_xrCreateInstance CreateInstance = nullptr;
  PFN_xrEnumerateInstanceExtensionProperties EnumerateInstanceExtensionProperties = nullptr;
#define PROSECTOR_XR_MEMBER(NAME) PFN_xr##NAME NAME = nullptr;
  PROSECTOR_XR_FUNCTIONS(PROSECTOR_XR_MEMBER)
  PROSECTOR_XR_GRAPHICS(PROSECTOR_XR_MEMBER)
  PROSECTOR_XR_HANDS(PROSECTOR_XR_MEMBER)
  PROSECTOR_XR_TIME(PROSECTOR_XR_MEMBER)
#undef PROSECTOR_XR_MEMBER
};

/// Exception for a failed OpenXR call, or for a session or instance that the runtime reports as lost.
struct XrFailure : std::runtime_error {
  XrFailure(const char* function, XrResult why);
  XrResult result;
};

/// Returns an English description of an OpenXR result code, for error messages.
std::string name_of(XrResult result);

/// Throws XrFailure if the result of the OpenXR function is an error or announces the loss of the session.
void check_xr(const char* function, XrResult result);
#define PROSECTOR_XR_CHECK(XR, NAME, ...) check_xr("xr" #NAME, (XR).NAME(__VA_ARGS__))

/// Loads the OpenXR loader library and returns the functions that need no instance; the others are null.
/// Throws InputError with the package to install if the loader is missing.
XrFunctions load_openxr();
/// Sets the function pointers of `xr` that belong to an OpenXR instance. Those of the extensions for hand
/// tracking and time conversion are set only if `hands` and `time` are true.
void load_functions(XrInstance instance, XrFunctions& xr, bool hands, bool time);

/// Returns an OpenXR structure whose `type` member is set and whose other members are zero.
template <class T>
T typed(XrStructureType type) {
  T out{};
  out.type = type;
  return out;
}

inline Pose pose_of(const XrPosef& p) {
  const auto& [x, y, z, w] = p.orientation;
  return {{p.position.x, p.position.y, p.position.z}, Quat(w, x, y, z).normalized()};
}
inline constexpr XrPosef xr_identity = {{0, 0, 0, 1}, {0, 0, 0}};

}  // namespace prosector
