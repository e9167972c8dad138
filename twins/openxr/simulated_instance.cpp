// Loader interface of the simulated OpenXR runtime: negotiation, instance, system, events.

#include <cstring>

#include "common/clock.h"
#include "twins/openxr/simulated_runtime.h"

namespace prosector {
namespace {

std::vector<const char*> extensions() {
  std::vector<const char*> out = {XR_KHR_OPENGL_ENABLE_EXTENSION_NAME, XR_MND_HEADLESS_EXTENSION_NAME,
                                  XR_EXT_HAND_TRACKING_EXTENSION_NAME,
                                  XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME,
                                  XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME};
  if (!simulated_runtime().settings.glx) out.push_back(XR_MNDX_EGL_ENABLE_EXTENSION_NAME);
  return out;
}

XrResult XRAPI_CALL enumerate_extensions(const char* layer, std::uint32_t capacity, std::uint32_t* count,
                                         XrExtensionProperties* out) {
  if (layer != nullptr) return XR_ERROR_API_LAYER_NOT_PRESENT;
  const std::vector<const char*> names = extensions();
  return enumerate(capacity, count, out, static_cast<std::uint32_t>(names.size()),
                   [&](std::uint32_t k, XrExtensionProperties& row) {
                     std::strcpy(row.extensionName, names[k]);
                     row.extensionVersion = 1;
                   });
}

XrResult XRAPI_CALL create_instance(const XrInstanceCreateInfo* info, XrInstance* out) {
  SimulatedRuntime& r = simulated_runtime();
  const std::lock_guard lock(r.mutex);
  r.begin_time();
  if (r.has_instance)
    return SimulatedRuntime::client_error("xrCreateInstance was called while an instance exists",
                                          XR_ERROR_LIMIT_REACHED);
  if (r.settings.away.holds(r.seconds_now())) return XR_ERROR_RUNTIME_UNAVAILABLE;
  for (std::uint32_t k = 0; k < info->enabledExtensionCount; ++k) {
    bool known = false;
    for (const char* name : extensions()) known |= std::strcmp(name, info->enabledExtensionNames[k]) == 0;
    if (!known)
      return SimulatedRuntime::client_error("xrCreateInstance was called with an unknown extension",
                                            XR_ERROR_EXTENSION_NOT_PRESENT);
  }
  r.has_instance = true;
  r.instance_lost = false;
  *out = reinterpret_cast<XrInstance>(1);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_instance(XrInstance) {
  SimulatedRuntime& r = simulated_runtime();
  const std::lock_guard lock(r.mutex);
  r.end_session();
  r.has_instance = false;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL instance_properties(XrInstance, XrInstanceProperties* out) {
  out->runtimeVersion = XR_MAKE_VERSION(1, 0, 0);
  std::strcpy(out->runtimeName, "Prosector's OpenXR double");
  return XR_SUCCESS;
}

XrResult XRAPI_CALL get_system(XrInstance, const XrSystemGetInfo* info, XrSystemId* out) {
  if (info->formFactor != XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY) return XR_ERROR_FORM_FACTOR_UNSUPPORTED;
  *out = 1;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL system_properties(XrInstance, XrSystemId, XrSystemProperties* out) {
  std::strcpy(out->systemName, "simulated headset");
  out->systemId = 1;
  for (auto* next = static_cast<XrBaseOutStructure*>(out->next); next != nullptr; next = next->next)
    if (next->type == XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT)
      reinterpret_cast<XrSystemHandTrackingPropertiesEXT*>(next)->supportsHandTracking = XR_TRUE;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL view_configuration_views(XrInstance, XrSystemId, XrViewConfigurationType type,
                                             std::uint32_t capacity, std::uint32_t* count,
                                             XrViewConfigurationView* out) {
  if (type != XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO) return XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED;
  const SimulatedRuntimeSettings& settings = simulated_runtime().settings;
  return enumerate(capacity, count, out, 2, [&](std::uint32_t, XrViewConfigurationView& view) {
    view.recommendedImageRectWidth = static_cast<std::uint32_t>(settings.width);
    view.recommendedImageRectHeight = static_cast<std::uint32_t>(settings.height);
    view.maxImageRectWidth = view.maxImageRectHeight = 4096;
    view.recommendedSwapchainSampleCount = view.maxSwapchainSampleCount = 1;
  });
}

XrResult XRAPI_CALL blend_modes(XrInstance, XrSystemId, XrViewConfigurationType, std::uint32_t capacity,
                                std::uint32_t* count, XrEnvironmentBlendMode* out) {
  return enumerate(capacity, count, out, 1, [](std::uint32_t, XrEnvironmentBlendMode& mode) {
    mode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  });
}

XrResult XRAPI_CALL graphics_requirements(XrInstance, XrSystemId, XrGraphicsRequirementsOpenGLKHR* out) {
  out->minApiVersionSupported = XR_MAKE_VERSION(3, 3, 0);
  out->maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL poll_event(XrInstance, XrEventDataBuffer* out) {
  SimulatedRuntime& r = simulated_runtime();
  const std::lock_guard lock(r.mutex);
  r.go_on();
  if (r.events.empty()) return XR_EVENT_UNAVAILABLE;
  *out = r.events.front();
  r.events.pop_front();
  return XR_SUCCESS;
}

XrResult XRAPI_CALL string_to_path(XrInstance, const char* text, XrPath* out) {
  return with_runtime([&](SimulatedRuntime& r) {
    std::size_t k = 1;
    while (k < r.paths.size() && r.paths[k] != text) ++k;
    if (k == r.paths.size()) r.paths.emplace_back(text);
    *out = k;
    return XR_SUCCESS;
  });
}

XrResult XRAPI_CALL convert_time(XrInstance, const timespec* from, XrTime* out) {
  *out = 1'000'000'000LL * from->tv_sec + from->tv_nsec;
  return XR_SUCCESS;
}

XrResult XRAPI_CALL get_proc(XrInstance, const char* name, PFN_xrVoidFunction* out) {
  for (const auto find : {instance_function, session_function, frame_function, input_function})
    if ((*out = find(name)) != nullptr) return XR_SUCCESS;
  return XR_ERROR_FUNCTION_UNSUPPORTED;
}

// The loader's interface, after the chapter on it in the specification.
struct LoaderInfo {
  int type;
  std::uint32_t version;
  std::size_t size;
  std::uint32_t least_interface, most_interface;
  XrVersion least_api, most_api;
};
struct RuntimeRequest {
  int type;
  std::uint32_t version;
  std::size_t size;
  std::uint32_t interface;
  XrVersion api;
  PFN_xrGetInstanceProcAddr get_instance_proc_addr;
};
constexpr int loader_info = 1, runtime_request = 3;

}  // namespace

PFN_xrVoidFunction instance_function(const std::string& name) {
  static const std::map<std::string, PFN_xrVoidFunction> table = {
      {"xrGetInstanceProcAddr", reinterpret_cast<PFN_xrVoidFunction>(get_proc)},
      {"xrEnumerateInstanceExtensionProperties", reinterpret_cast<PFN_xrVoidFunction>(enumerate_extensions)},
      {"xrCreateInstance", reinterpret_cast<PFN_xrVoidFunction>(create_instance)},
      {"xrDestroyInstance", reinterpret_cast<PFN_xrVoidFunction>(destroy_instance)},
      {"xrGetInstanceProperties", reinterpret_cast<PFN_xrVoidFunction>(instance_properties)},
      {"xrGetSystem", reinterpret_cast<PFN_xrVoidFunction>(get_system)},
      {"xrGetSystemProperties", reinterpret_cast<PFN_xrVoidFunction>(system_properties)},
      {"xrEnumerateViewConfigurationViews", reinterpret_cast<PFN_xrVoidFunction>(view_configuration_views)},
      {"xrEnumerateEnvironmentBlendModes", reinterpret_cast<PFN_xrVoidFunction>(blend_modes)},
      {"xrGetOpenGLGraphicsRequirementsKHR", reinterpret_cast<PFN_xrVoidFunction>(graphics_requirements)},
      {"xrPollEvent", reinterpret_cast<PFN_xrVoidFunction>(poll_event)},
      {"xrStringToPath", reinterpret_cast<PFN_xrVoidFunction>(string_to_path)},
      {"xrConvertTimespecTimeToTimeKHR", reinterpret_cast<PFN_xrVoidFunction>(convert_time)}};
  const auto found = table.find(name);
  return found == table.end() ? nullptr : found->second;
}

}  // namespace prosector

extern "C" __attribute__((visibility("default"))) XrResult xrNegotiateLoaderRuntimeInterface(
    const void* loader, void* request) {
  const auto& info = *static_cast<const prosector::LoaderInfo*>(loader);
  auto& out = *static_cast<prosector::RuntimeRequest*>(request);
  if (info.type != prosector::loader_info || out.type != prosector::runtime_request ||
      info.least_interface > 1)
    return XR_ERROR_INITIALIZATION_FAILED;
  out.interface = 1;
  out.api = XR_MAKE_VERSION(1, 0, 20);
  out.get_instance_proc_addr = prosector::get_proc;
  return XR_SUCCESS;
}
