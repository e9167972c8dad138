// Sessions of the simulated OpenXR runtime: spaces and the location of objects in them.

#include <dlfcn.h>

#include <algorithm>

#include "twins/openxr/simulated_runtime.h"

namespace prosector {
namespace {

constexpr double half_eye_distance = 0.032;  // m
constexpr XrFovf left_eye{-0.85F, 0.70F, 0.72F, -0.80F}, right_eye{-0.70F, 0.85F, 0.72F, -0.80F};

/// Returns the look-up function for OpenGL functions in an EGL context; null if the binding is not EGL.
PFNEGLGETPROCADDRESSPROC proc_of_egl(const void* binding) {
  const auto* egl = static_cast<const XrGraphicsBindingEGLMNDX*>(binding);
  return egl->type == XR_TYPE_GRAPHICS_BINDING_EGL_MNDX && egl->context != nullptr ? egl->getProcAddress
                                                                                   : nullptr;
}

/// Returns the look-up function for OpenGL functions in a GLX context, which must be current; null otherwise.
PFNEGLGETPROCADDRESSPROC proc_of_glx(const void* binding) {
  const auto* glx = static_cast<const XrGraphicsBindingOpenGLXlibKHR*>(binding);
  void* const library = dlopen("libGLX.so.0", RTLD_NOW);
  if (library == nullptr) return nullptr;
  const auto current = reinterpret_cast<GLXContext (*)()>(dlsym(library, "glXGetCurrentContext"));
  const bool fits = glx->type == XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR && glx->xDisplay != nullptr &&
                    glx->visualid != 0 && glx->glxFBConfig != nullptr && glx->glxDrawable != 0 &&
                    glx->glxContext != nullptr && glx->glxContext == current();
  return fits ? reinterpret_cast<PFNEGLGETPROCADDRESSPROC>(dlsym(library, "glXGetProcAddress")) : nullptr;
}

XrResult XRAPI_CALL create_session(XrInstance, const XrSessionCreateInfo* info, XrSession* out) {
  return with_runtime([&](SimulatedRuntime& r) {
    if (r.has_session)
      return SimulatedRuntime::client_error("xrCreateSession was called while a session exists",
                                            XR_ERROR_LIMIT_REACHED);
    // A session without graphics has no images: XR_MND_headless.
    r.get_proc = nullptr;
    if (info->next != nullptr) {
      r.get_proc = r.settings.glx ? proc_of_glx(info->next) : proc_of_egl(info->next);
      if (r.get_proc == nullptr)
        return SimulatedRuntime::client_error(
            "xrCreateSession was called without an OpenGL context that the runtime can use",
            XR_ERROR_GRAPHICS_DEVICE_INVALID);
    }
    r.has_session = true;
    r.enter(XR_SESSION_STATE_IDLE);
    r.enter(XR_SESSION_STATE_READY);
    *out = reinterpret_cast<XrSession>(1);
    return XR_SUCCESS;
  });
}

XrResult XRAPI_CALL destroy_session(XrSession) {
  SimulatedRuntime& r = simulated_runtime();
  const std::lock_guard lock(r.mutex);
  r.end_session();
  return XR_SUCCESS;
}

XrResult XRAPI_CALL begin_session(XrSession, const XrSessionBeginInfo*) {
  return with_session([&](SimulatedRuntime& r) {
    if (r.state != XR_SESSION_STATE_READY)
      return SimulatedRuntime::client_error("xrBeginSession was called although the session is not ready",
                                            XR_ERROR_SESSION_NOT_READY);
    r.running = true;
    return XR_SUCCESS;
  });
}

XrResult XRAPI_CALL end_session(XrSession) {
  return with_session([&](SimulatedRuntime& r) {
    if (r.state != XR_SESSION_STATE_STOPPING)
      return SimulatedRuntime::client_error("xrEndSession was called although the session is not stopping",
                                            XR_ERROR_SESSION_NOT_STOPPING);
    r.running = false;
    r.enter(XR_SESSION_STATE_IDLE);
    r.enter(XR_SESSION_STATE_EXITING);
    return XR_SUCCESS;
  });
}

XrResult XRAPI_CALL reference_spaces(XrSession, std::uint32_t capacity, std::uint32_t* count,
                                     XrReferenceSpaceType* out) {
  constexpr std::array<XrReferenceSpaceType, 3> kinds = {
      XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL, XR_REFERENCE_SPACE_TYPE_STAGE};
  return with_session([&](SimulatedRuntime& r) {
    return enumerate(capacity, count, out, r.settings.no_stage ? 2 : 3,
                     [&](std::uint32_t k, XrReferenceSpaceType& kind) { kind = kinds[k]; });
  });
}

Pose to_pose(const XrPosef& pose) {
  return {{pose.position.x, pose.position.y, pose.position.z},
          Quat(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z)};
}

XrResult add_space(SimulatedRuntime& r, const SimulatedSpace& space, XrSpace* out) {
  if (std::abs(space.offset.q.norm() - 1) > 0.01)
    return SimulatedRuntime::client_error("the orientation of a new space is not a unit quaternion",
                                          XR_ERROR_POSE_INVALID);
  *out = reinterpret_cast<XrSpace>(r.spaces.size());
  r.spaces.push_back(space);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL create_reference_space(XrSession, const XrReferenceSpaceCreateInfo* info, XrSpace* out) {
  return with_session([&](SimulatedRuntime& r) {
    SimulatedSpace space{SimulatedSpace::Kind::stage, right_hand, to_pose(info->poseInReferenceSpace)};
    if (info->referenceSpaceType == XR_REFERENCE_SPACE_TYPE_VIEW) space.kind = SimulatedSpace::Kind::head;
    if (info->referenceSpaceType == XR_REFERENCE_SPACE_TYPE_LOCAL) space.kind = SimulatedSpace::Kind::local;
    if (space.kind == SimulatedSpace::Kind::stage && r.settings.no_stage)
      return SimulatedRuntime::client_error(
          "a stage reference space was requested, but the runtime does not offer one",
          XR_ERROR_REFERENCE_SPACE_UNSUPPORTED);
    return add_space(r, space, out);
  });
}

XrResult XRAPI_CALL create_action_space(XrSession, const XrActionSpaceCreateInfo* info, XrSpace* out) {
  return with_session([&](SimulatedRuntime& r) {
    const std::size_t hand = r.paths.at(info->subactionPath).ends_with("left") ? left_hand : right_hand;
    return add_space(r, {SimulatedSpace::Kind::grip, hand, to_pose(info->poseInActionSpace)}, out);
  });
}

XrResult XRAPI_CALL destroy_space(XrSpace) {
  return XR_SUCCESS;
}

SimulatedSpace& space_of(SimulatedRuntime& r, XrSpace space) {
  return r.spaces.at(reinterpret_cast<std::size_t>(space));
}

XrResult XRAPI_CALL locate_space(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation* out) {
  return with_session([&](SimulatedRuntime& r) {
    if (time <= 0)
      return SimulatedRuntime::client_error("xrLocateSpace was called with an invalid time",
                                            XR_ERROR_TIME_INVALID);
    const auto what = r.world(space_of(r, space), time), in = r.world(space_of(r, base), time);
    out->locationFlags = 0;
    if (!what || !in) return XR_SUCCESS;
    out->locationFlags = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
                         XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
    out->pose = r.to_xr_pose(in->inverse() * *what);
    return XR_SUCCESS;
  });
}

XrResult XRAPI_CALL locate_views(XrSession, const XrViewLocateInfo* info, XrViewState* state,
                                 std::uint32_t capacity, std::uint32_t* count, XrView* out) {
  return with_session([&](SimulatedRuntime& r) {
    if (!r.running)
      return SimulatedRuntime::client_error("xrLocateViews was called although the session is not running",
                                            XR_ERROR_SESSION_NOT_RUNNING);
    const auto in = r.world(space_of(r, info->space), info->displayTime);
    if (!in)
      return SimulatedRuntime::client_error("xrLocateViews was called with a space that cannot be located",
                                            XR_ERROR_HANDLE_INVALID);
    const Pose head = in->inverse() * r.wearer.head(r.seconds(info->displayTime));
    state->viewStateFlags = XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;
    return enumerate(capacity, count, out, 2, [&](std::uint32_t eye, XrView& view) {
      const double side = eye == 0 ? -half_eye_distance : half_eye_distance;
      view.pose = r.to_xr_pose(head * Pose{{side, 0, 0}, Quat::Identity()});
      view.fov = eye == 0 ? left_eye : right_eye;
    });
  });
}

XrResult XRAPI_CALL create_tracker(XrSession, const XrHandTrackerCreateInfoEXT* info, XrHandTrackerEXT* out) {
  *out = reinterpret_cast<XrHandTrackerEXT>(info->hand == XR_HAND_LEFT_EXT ? 1 + left_hand : 1 + right_hand);
  return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_tracker(XrHandTrackerEXT) {
  return with_runtime([&](SimulatedRuntime& r) {
    return r.has_session ? XR_SUCCESS
                         : SimulatedRuntime::client_error(
                               "xrDestroyHandTrackerEXT was called after its session was destroyed",
                               XR_ERROR_HANDLE_INVALID);
  });
}

XrResult XRAPI_CALL locate_joints(XrHandTrackerEXT tracker, const XrHandJointsLocateInfoEXT* info,
                                  XrHandJointLocationsEXT* out) {
  return with_session([&](SimulatedRuntime& r) {
    if (out->jointCount != joints_per_hand)
      return SimulatedRuntime::client_error(
          "xrLocateHandJointsEXT was called with an array that does not have the number of joints of a hand",
          XR_ERROR_VALIDATION_FAILURE);
    out->isActive = !r.settings.controllers && r.takes_focus() ? XR_TRUE : XR_FALSE;
    const auto in = r.world(space_of(r, info->baseSpace), info->time);
    if (out->isActive == XR_FALSE || !in) return XR_SUCCESS;
    const std::size_t hand = reinterpret_cast<std::size_t>(tracker) - 1;
    const double time = r.seconds(info->time);
    const auto joints = hand_model_joints(hand, r.wearer.flexion(hand, time));
    const Pose wrist = in->inverse() * r.wearer.wrist(hand, time);
    for (std::size_t k = 0; k < joints_per_hand; ++k) {
      out->jointLocations[k].locationFlags =
          XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
      out->jointLocations[k].pose = r.to_xr_pose(wrist * joints[k]);
      out->jointLocations[k].radius = 0.01F;
    }
    return XR_SUCCESS;
  });
}

}  // namespace

PFN_xrVoidFunction session_function(const std::string& name) {
  static const std::map<std::string, PFN_xrVoidFunction> table = {
      {"xrCreateSession", reinterpret_cast<PFN_xrVoidFunction>(create_session)},
      {"xrDestroySession", reinterpret_cast<PFN_xrVoidFunction>(destroy_session)},
      {"xrBeginSession", reinterpret_cast<PFN_xrVoidFunction>(begin_session)},
      {"xrEndSession", reinterpret_cast<PFN_xrVoidFunction>(end_session)},
      {"xrEnumerateReferenceSpaces", reinterpret_cast<PFN_xrVoidFunction>(reference_spaces)},
      {"xrCreateReferenceSpace", reinterpret_cast<PFN_xrVoidFunction>(create_reference_space)},
      {"xrCreateActionSpace", reinterpret_cast<PFN_xrVoidFunction>(create_action_space)},
      {"xrDestroySpace", reinterpret_cast<PFN_xrVoidFunction>(destroy_space)},
      {"xrLocateSpace", reinterpret_cast<PFN_xrVoidFunction>(locate_space)},
      {"xrLocateViews", reinterpret_cast<PFN_xrVoidFunction>(locate_views)},
      {"xrCreateHandTrackerEXT", reinterpret_cast<PFN_xrVoidFunction>(create_tracker)},
      {"xrDestroyHandTrackerEXT", reinterpret_cast<PFN_xrVoidFunction>(destroy_tracker)},
      {"xrLocateHandJointsEXT", reinterpret_cast<PFN_xrVoidFunction>(locate_joints)}};
  const auto found = table.find(name);
  return found == table.end() ? nullptr : found->second;
}

}  // namespace prosector
