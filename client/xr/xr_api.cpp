#include "client/xr/xr_api.h"

#include <fmt/format.h>

#include <optional>

#include "common/error.h"
#include "drivers/ports/shared_library.h"

namespace prosector {
namespace {

constexpr const char* loader_name = "libopenxr_loader.so.1";

SharedLibrary open_loader() {
  try {
    return SharedLibrary(loader_name);
  } catch (const InputError&) {
    throw InputError(fmt::format(
        "--display openxr: the OpenXR loader {} is not installed; install libopenxr-loader1", loader_name));
  }
}

template <class Function>
void find(const XrFunctions& xr, XrInstance instance, const char* name, Function& out) {
  PFN_xrVoidFunction found = nullptr;
  check_xr(name, xr.GetInstanceProcAddr(instance, name, &found));
  out = reinterpret_cast<Function>(found);
}

}  // namespace

std::string name_of(XrResult result) {
  switch (result) {
    case XR_SESSION_LOSS_PENDING:
    case XR_ERROR_SESSION_LOST:
      return "the session is lost";
    case XR_ERROR_INSTANCE_LOST:
    case XR_ERROR_RUNTIME_FAILURE:
      return "the runtime failed";
    case XR_ERROR_RUNTIME_UNAVAILABLE:
      return "no runtime responds";
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE:
      return "the headset is not connected";
    default:
      return fmt::format("error {}", static_cast<int>(result));
  }
}

XrFailure::XrFailure(const char* function, XrResult why)
    : std::runtime_error(fmt::format("{} ({})", name_of(why), function)), result(why) {}

void check_xr(const char* function, XrResult result) {
  if (XR_FAILED(result) || result == XR_SESSION_LOSS_PENDING) throw XrFailure(function, result);
}

XrFunctions load_openxr() {
  static const SharedLibrary loader = open_loader();
  XrFunctions xr;
  loader.find("xrGetInstanceProcAddr", xr.GetInstanceProcAddr);
  find(xr, XR_NULL_HANDLE, "xrCreateInstance", xr.CreateInstance);
  find(xr, XR_NULL_HANDLE, "xrEnumerateInstanceExtensionProperties", xr.EnumerateInstanceExtensionProperties);
  return xr;
}

void load_functions(XrInstance instance, XrFunctions& xr, bool hands, bool time) {
#define PROSECTOR_XR_FIND(NAME) find(xr, instance, "xr" #NAME, xr.NAME);
  PROSECTOR_XR_FUNCTIONS(PROSECTOR_XR_FIND)
  PROSECTOR_XR_GRAPHICS(PROSECTOR_XR_FIND)
  if (hands) {
    PROSECTOR_XR_HANDS(PROSECTOR_XR_FIND)
  }
  if (time) {
    PROSECTOR_XR_TIME(PROSECTOR_XR_FIND)
  }
#undef PROSECTOR_XR_FIND
}

}  // namespace prosector
