#include "client/render/render_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "common/error.h"

namespace prosector {

void RenderTarget::bind(int width, int height) {
  if (width != width_ || height != height_) {
    release();
    allocate(width, height);
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_);
}

void RenderTarget::allocate(int width, int height) {
  width_ = width;
  height_ = height;
  const auto renderbuffer = [&](GLuint& id, GLenum format, int samples, GLenum attachment) {
    gl_.GenRenderbuffers(1, &id);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, id);
    if (samples > 1)
      gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    else
      gl_.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, id);
  };
  const auto check_complete = [&] {
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw InputError(fmt::format("OpenGL refuses a picture of {} × {} pixels with {} samples each", width,
                                   height, samples_));
  };
  gl_.GenFramebuffers(1, &drawn_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_);
  renderbuffer(color_, GL_RGBA8, samples_, GL_COLOR_ATTACHMENT0);
  renderbuffer(depth_, GL_DEPTH_COMPONENT24, samples_, GL_DEPTH_ATTACHMENT);
  check_complete();
  gl_.GenFramebuffers(1, &resolved_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_);
  renderbuffer(picture_, GL_RGBA8, 1, GL_COLOR_ATTACHMENT0);
  check_complete();
}

void RenderTarget::resolve(bool has_screen) {
  const auto copy = [this](GLuint from, GLuint to) {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, from);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  };
  gl_.Disable(GL_SCISSOR_TEST);
  copy(drawn_, resolved_);
  if (has_screen) copy(resolved_, 0);
}

Image RenderTarget::read() const {
  if (resolved_ == 0) throw std::logic_error("read_pixels before the first draw");
  Image image{width_, height_, {}};
  const std::size_t row = 3 * static_cast<std::size_t>(width_);
  image.rgb.resize(row * static_cast<std::size_t>(height_));
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  // OpenGL's rows run from the bottom.
  for (std::size_t top = 0, bottom = static_cast<std::size_t>(height_) - 1; top < bottom; ++top, --bottom)
    std::swap_ranges(image.rgb.begin() + static_cast<std::ptrdiff_t>(top * row),
                     image.rgb.begin() + static_cast<std::ptrdiff_t>((top + 1) * row),
                     image.rgb.begin() + static_cast<std::ptrdiff_t>(bottom * row));
  return image;
}

void RenderTarget::release() {
  gl_.DeleteFramebuffers(1, &drawn_);
  gl_.DeleteFramebuffers(1, &resolved_);
  for (GLuint* buffer : {&color_, &depth_, &picture_}) gl_.DeleteRenderbuffers(1, buffer);
  drawn_ = resolved_ = color_ = depth_ = picture_ = 0;
  width_ = height_ = 0;
}

}  // namespace prosector
