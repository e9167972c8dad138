#pragma once
// A window's context as EGL and GLX have it. Private to client/render.

#include "client/render/gl_context.h"

struct GLFWwindow;

namespace prosector {

/// Returns the context of a window that was made by EGL. Throws InputError where EGL doesn't know it.
EglHandles egl_of(GLFWwindow* window);
/// Returns the context of a window that was made by GLX, which is current. Throws InputError where GLX
/// doesn't know it.
GlxHandles glx_of(GLFWwindow* window);

}  // namespace prosector
