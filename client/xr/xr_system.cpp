#include "client/xr/xr_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "common/error.h"

namespace prosector {

std::vector<std::string> extensions_of(const XrFunctions& xr) {
  std::uint32_t count = 0;
  PROSECTOR_XR_CHECK(xr, EnumerateInstanceExtensionProperties, nullptr, 0, &count, nullptr);
  std::vector<XrExtensionProperties> rows(count, {XR_TYPE_EXTENSION_PROPERTIES, nullptr, {}, 0});
  PROSECTOR_XR_CHECK(xr, EnumerateInstanceExtensionProperties, nullptr, count, &count, rows.data());
  std::vector<std::string> out;
  for (const XrExtensionProperties& row : rows) out.emplace_back(row.extensionName);
  return out;
}

XrSystem::XrSystem(bool by_egl) : xr_(load_openxr()) {
  create(by_egl);
  try {
    find_headset();
  } catch (...) {
    xr_.DestroyInstance(instance_);
    throw;
  }
}

XrSystem::~XrSystem() {
  xr_.DestroyInstance(instance_);
}

void XrSystem::create(bool by_egl) {
  const std::vector<std::string> offered = extensions_of(xr_);
  const auto has = [&](const char* name) { return std::ranges::find(offered, name) != offered.end(); };
  std::vector<const char*> wanted = {XR_KHR_OPENGL_ENABLE_EXTENSION_NAME};
  if (by_egl) wanted.push_back(XR_MNDX_EGL_ENABLE_EXTENSION_NAME);
  for (const char* name : wanted)
    if (!has(name))
      throw InputError(fmt::format(
          "--display openxr: the OpenXR runtime lacks the extension {}; use another runtime", name));
  const bool hands = has(XR_EXT_HAND_TRACKING_EXTENSION_NAME);
  const bool time = has(XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME);
  if (hands) wanted.push_back(XR_EXT_HAND_TRACKING_EXTENSION_NAME);
  if (time) wanted.push_back(XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME);
  auto info = typed<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
  std::strcpy(info.applicationInfo.applicationName, "Prosector");
  info.applicationInfo.applicationVersion = 1;
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
  info.enabledExtensionCount = static_cast<std::uint32_t>(wanted.size());
  info.enabledExtensionNames = wanted.data();
  PROSECTOR_XR_CHECK(xr_, CreateInstance, &info, &instance_);
  load_functions(instance_, xr_, hands, time);
  auto properties = typed<XrInstanceProperties>(XR_TYPE_INSTANCE_PROPERTIES);
  PROSECTOR_XR_CHECK(xr_, GetInstanceProperties, instance_, &properties);
  runtime_ = properties.runtimeName;
}

void XrSystem::find_headset() {
  auto wish = typed<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
  wish.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
  PROSECTOR_XR_CHECK(xr_, GetSystem, instance_, &wish, &id_);
  auto hands = typed<XrSystemHandTrackingPropertiesEXT>(XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT);
  auto properties = typed<XrSystemProperties>(XR_TYPE_SYSTEM_PROPERTIES);
  if (xr_.CreateHandTrackerEXT != nullptr) properties.next = &hands;
  PROSECTOR_XR_CHECK(xr_, GetSystemProperties, instance_, id_, &properties);
  headset_ = properties.systemName;
  tracks_hands_ = hands.supportsHandTracking == XR_TRUE;
  views_.fill(typed<XrViewConfigurationView>(XR_TYPE_VIEW_CONFIGURATION_VIEW));
  std::uint32_t count = 0;
  PROSECTOR_XR_CHECK(xr_, EnumerateViewConfigurationViews, instance_, id_,
                     XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, 2, &count, views_.data());
  PROSECTOR_XR_CHECK(xr_, EnumerateEnvironmentBlendModes, instance_, id_,
                     XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, 0, &count, nullptr);
  std::vector<XrEnvironmentBlendMode> modes(count);
  PROSECTOR_XR_CHECK(xr_, EnumerateEnvironmentBlendModes, instance_, id_,
                     XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, count, &count, modes.data());
  if (!modes.empty()) blend_mode_ = modes.front();
  auto needed = typed<XrGraphicsRequirementsOpenGLKHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
  PROSECTOR_XR_CHECK(xr_, GetOpenGLGraphicsRequirementsKHR, instance_, id_, &needed);
}

std::string XrSystem::description() const {
  return fmt::format("{} by {}, {} × {} pixels an eye{}", headset_, runtime_,
                     views_[0].recommendedImageRectWidth, views_[0].recommendedImageRectHeight,
                     tracks_hands_ ? ", with hands" : "");
}

}  // namespace prosector
