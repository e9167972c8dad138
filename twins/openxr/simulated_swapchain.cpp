#include "twins/openxr/simulated_swapchain.h"

#include <GL/glcorearb.h>

#include <filesystem>
#include <fstream>

namespace prosector {
namespace {

template <class Function>
Function find_gl(SimulatedSwapchain::FindFunction find, const char* name) {
  return reinterpret_cast<Function>(find(name));
}

}  // namespace

SimulatedSwapchain::SimulatedSwapchain(FindFunction find, int width, int height, std::int64_t format)
    : find_(find), width_(width), height_(height) {
  const auto bind = find_gl<PFNGLBINDTEXTUREPROC>(find, "glBindTexture");
  GLint before = 0;
  find_gl<PFNGLGETINTEGERVPROC>(find, "glGetIntegerv")(GL_TEXTURE_BINDING_2D, &before);
  find_gl<PFNGLGENTEXTURESPROC>(find, "glGenTextures")(static_cast<GLsizei>(textures_.size()),
                                                       textures_.data());
  for (const GLuint texture : textures_) {
    bind(GL_TEXTURE_2D, texture);
    find_gl<PFNGLTEXIMAGE2DPROC>(find, "glTexImage2D")(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width,
                                                       height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    find_gl<PFNGLTEXPARAMETERIPROC>(find, "glTexParameteri")(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  }
  bind(GL_TEXTURE_2D, static_cast<GLuint>(before));
}

SimulatedSwapchain::~SimulatedSwapchain() {
  find_gl<PFNGLDELETETEXTURESPROC>(find_, "glDeleteTextures")(static_cast<GLsizei>(textures_.size()),
                                                              textures_.data());
}

std::uint32_t SimulatedSwapchain::acquire() {
  acquired_ = true;
  return next_;
}

void SimulatedSwapchain::release() {
  acquired_ = false;
  last_ = next_;
  next_ = (next_ + 1) % static_cast<std::uint32_t>(textures_.size());
}

bool SimulatedSwapchain::holds(const ImageRect& part) const {
  return part.x >= 0 && part.y >= 0 && part.width > 0 && part.height > 0 && part.x + part.width <= width_ &&
         part.y + part.height <= height_;
}

void SimulatedSwapchain::write(const ImageRect& part, const std::string& file) const {
  const auto bind = find_gl<PFNGLBINDFRAMEBUFFERPROC>(find_, "glBindFramebuffer");
  GLint before = 0;
  find_gl<PFNGLGETINTEGERVPROC>(find_, "glGetIntegerv")(GL_READ_FRAMEBUFFER_BINDING, &before);
  GLuint framebuffer = 0;
  find_gl<PFNGLGENFRAMEBUFFERSPROC>(find_, "glGenFramebuffers")(1, &framebuffer);
  bind(GL_READ_FRAMEBUFFER, framebuffer);
  find_gl<PFNGLFRAMEBUFFERTEXTURE2DPROC>(find_, "glFramebufferTexture2D")(
      GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures_[last_], 0);
  const std::size_t row = 3 * static_cast<std::size_t>(part.width);
  std::string pixels(row * static_cast<std::size_t>(part.height), '\0');
  find_gl<PFNGLPIXELSTOREIPROC>(find_, "glPixelStorei")(GL_PACK_ALIGNMENT, 1);
  find_gl<PFNGLREADPIXELSPROC>(find_, "glReadPixels")(part.x, part.y, part.width, part.height, GL_RGB,
                                                      GL_UNSIGNED_BYTE, pixels.data());
  bind(GL_READ_FRAMEBUFFER, static_cast<GLuint>(before));
  find_gl<PFNGLDELETEFRAMEBUFFERSPROC>(find_, "glDeleteFramebuffers")(1, &framebuffer);
  std::ofstream out(file + ".new", std::ios::binary);
  out << "P6\n" << part.width << ' ' << part.height << "\n255\n";
  for (int y = part.height - 1; y >= 0; --y)  // OpenGL's rows start at the bottom
    out.write(pixels.data() + row * static_cast<std::size_t>(y), static_cast<std::streamsize>(row));
  out.close();
  std::filesystem::rename(file + ".new", file);
}

}  // namespace prosector
