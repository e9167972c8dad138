#include "client/xr/xr_session.h"

#include <algorithm>

#include "client/language/catalogue.h"
#include "common/clock.h"
#include "common/error.h"

namespace prosector {
namespace {

// The renderer's output is encoded as sRGB. The values are OpenGL's constants, so that its header is not
// needed.
constexpr std::int64_t gl_srgb8_alpha8 = 0x8C43, gl_rgba8 = 0x8058;
constexpr float standing_eyes = 1.6F;  // m, assumed eye height if the runtime doesn't know the floor

}  // namespace

XrSession HeadsetSession::begin_session(const XrSystem& system, const GlContext& context) {
  auto by_egl = typed<XrGraphicsBindingEGLMNDX>(XR_TYPE_GRAPHICS_BINDING_EGL_MNDX);
  auto by_glx = typed<XrGraphicsBindingOpenGLXlibKHR>(XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR);
  auto info = typed<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
  info.systemId = system.id();
  const ContextHandles handles = context.handles();
  if (const auto* egl = std::get_if<EglHandles>(&handles)) {
    by_egl.getProcAddress = eglGetProcAddress;
    by_egl.display = egl->display;
    by_egl.config = egl->config;
    by_egl.context = egl->context;
    info.next = &by_egl;
  } else if (const auto* glx = std::get_if<GlxHandles>(&handles)) {
    by_glx.xDisplay = static_cast<Display*>(glx->display);
    by_glx.visualid = static_cast<std::uint32_t>(glx->visual);
    by_glx.glxFBConfig = static_cast<GLXFBConfig>(glx->config);
    by_glx.glxDrawable = glx->drawable;
    by_glx.glxContext = static_cast<GLXContext>(glx->context);
    info.next = &by_glx;
  }
  XrSession out = XR_NULL_HANDLE;
  PROSECTOR_XR_CHECK(system.xr(), CreateSession, system.instance(), &info, &out);
  return out;
}

HeadsetSession::HeadsetSession(const XrSystem& system, const GlContext& context,
                               std::function<void(const std::string&)> report)
    : system_(system),
      xr_(system.xr()),
      context_(context),
      report_(std::move(report)),
      session_(begin_session(system, context)),
      width_(static_cast<int>(system.views()[0].recommendedImageRectWidth)),
      height_(static_cast<int>(system.views()[0].recommendedImageRectHeight)),
      input_(system, session_) {
  width_ = std::min(width_, max_picture_size / 2);
  height_ = std::min(height_, max_picture_size);
  make_stage();
  make_pictures();
}

// Destroying the session also destroys its spaces and textures. The render commands must be complete before
// that, and a lost runtime does not wait for them.
HeadsetSession::~HeadsetSession() {
  reinterpret_cast<void (*)()>(context_.proc("glFinish"))();
  xr_.DestroySession(session_);
}

void HeadsetSession::make_stage() {
  std::uint32_t count = 0;
  PROSECTOR_XR_CHECK(xr_, EnumerateReferenceSpaces, session_, 0, &count, nullptr);
  std::vector<XrReferenceSpaceType> kinds(count);
  PROSECTOR_XR_CHECK(xr_, EnumerateReferenceSpaces, session_, count, &count, kinds.data());
  auto info = typed<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
  info.poseInReferenceSpace = xr_identity;
  info.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_STAGE;
  if (std::ranges::find(kinds, XR_REFERENCE_SPACE_TYPE_STAGE) == kinds.end()) {
    info.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
    info.poseInReferenceSpace.position.y = -standing_eyes;
    report_(msg("headset: floor height unknown; standing height is assumed"));
  }
  PROSECTOR_XR_CHECK(xr_, CreateReferenceSpace, session_, &info, &stage_);
}

/// Creates the swapchain with both eyes side by side.
void HeadsetSession::make_pictures() {
  std::uint32_t count = 0;
  PROSECTOR_XR_CHECK(xr_, EnumerateSwapchainFormats, session_, 0, &count, nullptr);
  std::vector<std::int64_t> formats(count);
  PROSECTOR_XR_CHECK(xr_, EnumerateSwapchainFormats, session_, count, &count, formats.data());
  const auto offers = [&](std::int64_t format) {
    return std::ranges::find(formats, format) != formats.end();
  };
  if (!offers(gl_srgb8_alpha8) && !offers(gl_rgba8))
    throw InputError("--display openxr: the runtime supports neither SRGB8_ALPHA8 nor RGBA8 images");
  auto info = typed<XrSwapchainCreateInfo>(XR_TYPE_SWAPCHAIN_CREATE_INFO);
  info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT;
  info.format = offers(gl_srgb8_alpha8) ? gl_srgb8_alpha8 : gl_rgba8;
  info.sampleCount = 1;
  info.width = static_cast<std::uint32_t>(2 * width_);
  info.height = static_cast<std::uint32_t>(height_);
  info.faceCount = info.arraySize = info.mipCount = 1;
  PROSECTOR_XR_CHECK(xr_, CreateSwapchain, session_, &info, &pictures_);
  PROSECTOR_XR_CHECK(xr_, EnumerateSwapchainImages, pictures_, 0, &count, nullptr);
  images_.assign(count, {XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR, nullptr, 0});
  PROSECTOR_XR_CHECK(xr_, EnumerateSwapchainImages, pictures_, count, &count,
                     reinterpret_cast<XrSwapchainImageBaseHeader*>(images_.data()));
}

void HeadsetSession::follow_events() {
  while (true) {
    auto event = typed<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
    const XrResult result = xr_.PollEvent(system_.instance(), &event);
    check_xr("xrPollEvent", result);
    if (result == XR_EVENT_UNAVAILABLE) return;
    if (event.type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED)
      enter(reinterpret_cast<const XrEventDataSessionStateChanged&>(event).state);
    else if (event.type == XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING)
      throw XrFailure("event", XR_ERROR_INSTANCE_LOST);
    else if (event.type == XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING)
      report_(msg("headset: the room was re-centred"));
  }
}

void HeadsetSession::enter(XrSessionState state) {
  state_ = state;
  switch (state) {
    case XR_SESSION_STATE_READY: {
      auto info = typed<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
      info.primaryViewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
      PROSECTOR_XR_CHECK(xr_, BeginSession, session_, &info);
      running_ = true;
      break;
    }
    case XR_SESSION_STATE_STOPPING:
      PROSECTOR_XR_CHECK(xr_, EndSession, session_);
      running_ = false;
      report_(msg("headset: taken off"));
      break;
    case XR_SESSION_STATE_EXITING:
      over_ = true;
      break;
    case XR_SESSION_STATE_LOSS_PENDING:
      throw XrFailure("event", XR_ERROR_SESSION_LOST);
    default:
      break;
  }
  follow_focus(state == XR_SESSION_STATE_FOCUSED);
}

void HeadsetSession::follow_focus(bool focused) {
  if (focused_ && !focused && state_ == XR_SESSION_STATE_VISIBLE)
    report_(
        msg("headset: hand tracking paused while another program, such as the headset's menu, has the "
            "input focus"));
  if (!focused_ && focused && had_focus_) report_(msg("headset: hand tracking restored"));
  focused_ = focused;
  had_focus_ = had_focus_ || focused;
}

bool HeadsetSession::wait() {
  frame_ = typed<XrFrameState>(XR_TYPE_FRAME_STATE);
  const auto wait_info = typed<XrFrameWaitInfo>(XR_TYPE_FRAME_WAIT_INFO);
  PROSECTOR_XR_CHECK(xr_, WaitFrame, session_, &wait_info, &frame_);
  const auto begin_info = typed<XrFrameBeginInfo>(XR_TYPE_FRAME_BEGIN_INFO);
  PROSECTOR_XR_CHECK(xr_, BeginFrame, session_, &begin_info);
  return frame_.shouldRender == XR_TRUE;
}

void HeadsetSession::sync() {
  input_.sync(focused_);
  synced_ns_ = frame_.predictedDisplayTime;
}

std::optional<std::array<EyeView, 2>> HeadsetSession::eyes() {
  auto wish = typed<XrViewLocateInfo>(XR_TYPE_VIEW_LOCATE_INFO);
  wish.viewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
  wish.displayTime = frame_.predictedDisplayTime;
  wish.space = stage_;
  auto state = typed<XrViewState>(XR_TYPE_VIEW_STATE);
  views_.fill(typed<XrView>(XR_TYPE_VIEW));
  std::uint32_t count = 0;
  PROSECTOR_XR_CHECK(xr_, LocateViews, session_, &wish, &state, 2, &count, views_.data());
  constexpr XrViewStateFlags known = XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;
  if ((state.viewStateFlags & known) != known || count != 2) return std::nullopt;
  std::array<EyeView, 2> out;
  for (std::size_t eye = 0; eye < 2; ++eye) {
    const auto& [left, right, up, down] = views_[eye].fov;
    out[eye] = {pose_of(views_[eye].pose), left, right, up, down};
    if (!is_usable(out[eye])) return std::nullopt;
  }
  return out;
}

TrackedUser HeadsetSession::user_now() const {
  if (!system_.converts_time()) return input_.locate(stage_, synced_ns_);
  const std::int64_t now = monotonic_ns();
  constexpr std::int64_t second = 1'000'000'000;
  const timespec as_timespec{now / second, now % second};
  XrTime time = 0;
  PROSECTOR_XR_CHECK(xr_, ConvertTimespecTimeToTimeKHR, system_.instance(), &as_timespec, &time);
  return input_.locate(stage_, time);
}

void HeadsetSession::end(const std::function<void(unsigned texture)>& draw) {
  const auto acquire = typed<XrSwapchainImageAcquireInfo>(XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO);
  std::uint32_t index = 0;
  PROSECTOR_XR_CHECK(xr_, AcquireSwapchainImage, pictures_, &acquire, &index);
  auto wait_info = typed<XrSwapchainImageWaitInfo>(XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
  wait_info.timeout = XR_INFINITE_DURATION;
  PROSECTOR_XR_CHECK(xr_, WaitSwapchainImage, pictures_, &wait_info);
  draw(images_.at(index).image);
  const auto release = typed<XrSwapchainImageReleaseInfo>(XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO);
  PROSECTOR_XR_CHECK(xr_, ReleaseSwapchainImage, pictures_, &release);
  std::array<XrCompositionLayerProjectionView, 2> seen;
  for (std::size_t eye = 0; eye < 2; ++eye) {
    seen[eye] = typed<XrCompositionLayerProjectionView>(XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW);
    seen[eye].pose = views_[eye].pose;
    seen[eye].fov = views_[eye].fov;
    seen[eye].subImage.swapchain = pictures_;
    seen[eye].subImage.imageRect = {{static_cast<int>(eye) * width_, 0}, {width_, height_}};
  }
  auto layer = typed<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
  layer.space = stage_;
  layer.viewCount = 2;
  layer.views = seen.data();
  end(reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer));
}

void HeadsetSession::end_without_image() {
  end(static_cast<const XrCompositionLayerBaseHeader*>(nullptr));
}

void HeadsetSession::end(const XrCompositionLayerBaseHeader* layer) {
  auto info = typed<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
  info.displayTime = frame_.predictedDisplayTime;
  info.environmentBlendMode = system_.blend_mode();
  info.layerCount = layer != nullptr ? 1 : 0;
  info.layers = layer != nullptr ? &layer : nullptr;
  PROSECTOR_XR_CHECK(xr_, EndFrame, session_, &info);
}

}  // namespace prosector
