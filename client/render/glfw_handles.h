#pragma once
// EGL and GLX handles of a window's context. Private to client/render.

#include "client/render/gl_context.h"

struct GLFWwindow;

namespace prosector {

/// Returns the handles of a window's EGL context. Throws InputError if EGL does not know the context.
EglHandles egl_of(GLFWwindow* window);
/// Returns the handles of a window's GLX context, which must be current. Throws InputError if GLX does not
/// know the context.
GlxHandles glx_of(GLFWwindow* window);

}  // namespace prosector
