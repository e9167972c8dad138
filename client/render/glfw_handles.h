#pragma once
// EGL and GLX handles of a window's context. Private to client/render.

#include "client/render/gl_context.h"

struct GLFWwindow;

namespace prosector {

/// Returns the EGL handles of the window's OpenGL context, for libraries that share it. Throws InputError if
/// EGL does not know the context.
EglHandles egl_of(GLFWwindow* window);
/// Returns the GLX handles of the window's OpenGL context, which must be current, for libraries that share
/// it. Throws InputError if GLX does not know the context.
GlxHandles glx_of(GLFWwindow* window);

}  // namespace prosector
