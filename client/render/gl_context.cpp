#include "client/render/gl_context.h"

#include <fmt/format.h>

#include "client/render/gl.h"
#include "common/error.h"

namespace prosector {

std::unique_ptr<GlContext> make_offscreen_context(int width, int height) {
  check_picture_size(width, height);
  std::string egl_failure;
  try {
    return make_egl_context(width, height);
  } catch (const InputError& error) {
    egl_failure = error.what();
  }
  try {
    return make_osmesa_context(width, height);
  } catch (const InputError& error) {
    throw InputError(fmt::format("no offscreen OpenGL 3.3:\n  {}\n  {}", egl_failure, error.what()));
  }
}

void check_picture_size(int width, int height) {
  if (width < 1 || height < 1 || width > max_picture_size || height > max_picture_size)
    throw InputError(fmt::format("a frame of {} × {} pixels is not possible: each side must be 1…{} pixels",
                                 width, height, max_picture_size));
}

std::string describe_gl(const GlContext& context, const std::string& kind) {
  const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(context.proc("glGetString"));
  const auto text = [&](GLenum name) {
    const GLubyte* s = get_string(name);
    return s ? std::string(reinterpret_cast<const char*>(s)) : std::string("unknown");
  };
  return fmt::format("{}, {}, {}", kind, text(GL_RENDERER), text(GL_VERSION));
}

}  // namespace prosector
