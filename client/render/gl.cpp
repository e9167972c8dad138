#include "client/render/gl.h"

#include <fmt/format.h>

#include "common/error.h"

namespace prosector {

Gl load_gl(const GlContext& context) {
  Gl gl;
  const auto load = [&context]<class Function>(Function& function, const char* name) {
    function = reinterpret_cast<Function>(context.proc(name));
    if (!function)
      throw InputError(fmt::format("{}: the function {} is missing; a driver with OpenGL 3.3 core is needed",
                                   context.description(), name));
  };
#define PROSECTOR_GL_LOAD(TYPE, NAME) load(gl.NAME, "gl" #NAME);
  PROSECTOR_GL_FUNCTIONS(PROSECTOR_GL_LOAD)
#undef PROSECTOR_GL_LOAD
  return gl;
}

}  // namespace prosector
