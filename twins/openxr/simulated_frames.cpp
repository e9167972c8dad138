// Frames and swapchain images of the simulated OpenXR runtime.

#include <chrono>
#include <thread>

#include "common/clock.h"
#include "twins/openxr/simulated_runtime.h"

namespace prosector {
namespace {

constexpr std::int64_t gl_srgb8_alpha8 = 0x8C43, gl_rgba8 = 0x8058;
constexpr std::array<const char*, 2> picture_names = {"left.ppm", "right.ppm"};

XrResult XRAPI_CALL swapchain_formats(XrSession, std::uint32_t capacity, std::uint32_t* count,
                                      std::int64_t* out) {
  return enumerate(capacity, count, out, 2, [](std::uint32_t k, std::int64_t& format) {
    format = k == 0 ? gl_srgb8_alpha8 : gl_rgba8;
  });
}

XrResult XRAPI_CALL create_swapchain(XrSession, const XrSwapchainCreateInfo* info, XrSwapchain* out) {
  return with_session([&](SimulatedRuntime& r) {
    if (r.get_proc == nullptr)
      return SimulatedRuntime::client_error("a swapchain was created without a graphics binding",
                                            XR_ERROR_FEATURE_UNSUPPORTED);
    r.pictures.emplace(r.get_proc, static_cast<int>(info->width), static_cast<int>(info->height),
                       info->format);
    *out = reinterpret_cast<XrSwapchain>(1);
    return XR_SUCCESS;
  });
}

XrResult XRAPI_CALL destroy_swapchain(XrSwapchain) {
  return with_runtime([&](SimulatedRuntime& r) {
    r.pictures.reset();
    return XR_SUCCESS;
  });
}

XrResult XRAPI_CALL swapchain_images(XrSwapchain, std::uint32_t capacity, std::uint32_t* count,
                                     XrSwapchainImageBaseHeader* out) {
  return with_session([&](SimulatedRuntime& r) {
    const auto& textures = r.pictures->textures();
    return enumerate(capacity, count, reinterpret_cast<XrSwapchainImageOpenGLKHR*>(out),
                     static_cast<std::uint32_t>(textures.size()),
                     [&](std::uint32_t k, XrSwapchainImageOpenGLKHR& image) { image.image = textures[k]; });
  });
}

XrResult XRAPI_CALL acquire_image(XrSwapchain, const XrSwapchainImageAcquireInfo*, std::uint32_t* out) {
  return with_session([&](SimulatedRuntime& r) {
    if (r.pictures->acquired())
      return SimulatedRuntime::client_error(
          "a second swapchain image was acquired before the first was released", XR_ERROR_CALL_ORDER_INVALID);
    *out = r.pictures->acquire();
    return XR_SUCCESS;
  });
}

XrResult XRAPI_CALL wait_image(XrSwapchain, const XrSwapchainImageWaitInfo*) {
  return with_session([&](SimulatedRuntime& r) {
    return r.pictures->acquired() ? XR_SUCCESS
                                  : SimulatedRuntime::client_error(
                                        "xrWaitSwapchainImage was called without an acquired swapchain image",
                                        XR_ERROR_CALL_ORDER_INVALID);
  });
}

XrResult XRAPI_CALL release_image(XrSwapchain, const XrSwapchainImageReleaseInfo*) {
  return with_session([&](SimulatedRuntime& r) {
    if (!r.pictures->acquired())
      return SimulatedRuntime::client_error(
          "xrReleaseSwapchainImage was called without an acquired swapchain image",
          XR_ERROR_CALL_ORDER_INVALID);
    r.pictures->release();
    return XR_SUCCESS;
  });
}

/// Advances the session by one state towards focus.
void rise(SimulatedRuntime& r) {
  if (r.state == XR_SESSION_STATE_READY)
    r.enter(XR_SESSION_STATE_SYNCHRONIZED);
  else if (r.state == XR_SESSION_STATE_SYNCHRONIZED)
    r.enter(XR_SESSION_STATE_VISIBLE);
  else if (r.state == XR_SESSION_STATE_VISIBLE && !r.settings.unfocused.holds(r.seconds_now()))
    r.enter(XR_SESSION_STATE_FOCUSED);
}

XrResult XRAPI_CALL wait_frame(XrSession, const XrFrameWaitInfo*, XrFrameState* out) {
  SimulatedRuntime& r = simulated_runtime();
  const auto period = static_cast<std::int64_t>(1e9 / r.settings.rate);
  std::int64_t next = 0;
  {
    const std::lock_guard lock(r.mutex);
    next = std::max(r.shown_ns, monotonic_ns());
  }
  next += period - next % period;
  std::this_thread::sleep_for(std::chrono::nanoseconds(next - period / 2 - monotonic_ns()));
  return with_session([&](SimulatedRuntime& r) {
    if (!r.running)
      return SimulatedRuntime::client_error("xrWaitFrame was called although the session is not running",
                                            XR_ERROR_SESSION_NOT_RUNNING);
    if (r.phase == FramePhase::waited)
      return SimulatedRuntime::client_error("xrWaitFrame was called twice without xrBeginFrame",
                                            XR_ERROR_CALL_ORDER_INVALID);
    r.phase = FramePhase::waited;
    r.shown_ns = next;
    out->predictedDisplayTime = next + period;
    out->predictedDisplayPeriod = period;
    out->shouldRender = r.state == XR_SESSION_STATE_VISIBLE || r.takes_focus() ? XR_TRUE : XR_FALSE;
    return XR_SUCCESS;
  });
}

XrResult XRAPI_CALL begin_frame(XrSession, const XrFrameBeginInfo*) {
  return with_session([&](SimulatedRuntime& r) {
    if (r.phase != FramePhase::waited)
      return SimulatedRuntime::client_error("xrBeginFrame was called without xrWaitFrame before",
                                            XR_ERROR_CALL_ORDER_INVALID);
    r.phase = FramePhase::begun;
    return XR_SUCCESS;
  });
}

XrResult show(SimulatedRuntime& r, const XrCompositionLayerProjection& layer) {
  if (layer.type != XR_TYPE_COMPOSITION_LAYER_PROJECTION || layer.viewCount != 2)
    return SimulatedRuntime::client_error("the composition layer is not a projection layer of two views",
                                          XR_ERROR_LAYER_INVALID);
  if (r.pictures->acquired())
    return SimulatedRuntime::client_error("the frame ends before its swapchain image was released",
                                          XR_ERROR_LAYER_INVALID);
  for (std::uint32_t eye = 0; eye < 2; ++eye) {
    const XrCompositionLayerProjectionView& view = layer.views[eye];
    const auto& [x, y, z, w] = view.pose.orientation;
    if (!(std::abs(std::hypot(std::hypot(x, y), std::hypot(z, w)) - 1) < 0.01F))
      return SimulatedRuntime::client_error("the orientation of an eye's view is not a unit quaternion",
                                            XR_ERROR_POSE_INVALID);
    const auto& [offset, size] = view.subImage.imageRect;
    const ImageRect part{offset.x, offset.y, size.width, size.height};
    if (!r.pictures->holds(part))
      return SimulatedRuntime::client_error("the image rectangle of a view exceeds the swapchain image",
                                            XR_ERROR_SWAPCHAIN_RECT_INVALID);
    if (!r.settings.pictures.empty()) r.pictures->write(part, r.settings.pictures + "/" + picture_names[eye]);
  }
  return XR_SUCCESS;
}

XrResult XRAPI_CALL end_frame(XrSession, const XrFrameEndInfo* info) {
  return with_session([&](SimulatedRuntime& r) {
    if (r.phase != FramePhase::begun)
      return SimulatedRuntime::client_error("xrEndFrame was called without xrBeginFrame before",
                                            XR_ERROR_CALL_ORDER_INVALID);
    r.phase = FramePhase::none;
    if (info->environmentBlendMode != XR_ENVIRONMENT_BLEND_MODE_OPAQUE)
      return SimulatedRuntime::client_error(
          "the frame has a blend mode that the runtime does not offer; only opaque is allowed",
          XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED);
    rise(r);
    if (r.seconds_now() >= r.settings.frame_refused) {
      r.settings.frame_refused = Span().begin;
      return XR_ERROR_RUNTIME_FAILURE;
    }
    if (info->layerCount == 0) return XR_SUCCESS;
    return show(r, *reinterpret_cast<const XrCompositionLayerProjection*>(info->layers[0]));
  });
}

}  // namespace

PFN_xrVoidFunction frame_function(const std::string& name) {
  static const std::map<std::string, PFN_xrVoidFunction> table = {
      {"xrEnumerateSwapchainFormats", reinterpret_cast<PFN_xrVoidFunction>(swapchain_formats)},
      {"xrCreateSwapchain", reinterpret_cast<PFN_xrVoidFunction>(create_swapchain)},
      {"xrDestroySwapchain", reinterpret_cast<PFN_xrVoidFunction>(destroy_swapchain)},
      {"xrEnumerateSwapchainImages", reinterpret_cast<PFN_xrVoidFunction>(swapchain_images)},
      {"xrAcquireSwapchainImage", reinterpret_cast<PFN_xrVoidFunction>(acquire_image)},
      {"xrWaitSwapchainImage", reinterpret_cast<PFN_xrVoidFunction>(wait_image)},
      {"xrReleaseSwapchainImage", reinterpret_cast<PFN_xrVoidFunction>(release_image)},
      {"xrWaitFrame", reinterpret_cast<PFN_xrVoidFunction>(wait_frame)},
      {"xrBeginFrame", reinterpret_cast<PFN_xrVoidFunction>(begin_frame)},
      {"xrEndFrame", reinterpret_cast<PFN_xrVoidFunction>(end_frame)}};
  const auto found = table.find(name);
  return found == table.end() ? nullptr : found->second;
}

}  // namespace prosector
