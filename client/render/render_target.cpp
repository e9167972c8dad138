#include "client/render/render_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "common/error.h"

namespace prosector {

RenderTarget::RenderTarget(const Gl& gl, const std::filesystem::path& shaders,
                           const RendererSettings& settings)
    : gl_(gl), samples_(settings.samples) {
  if (samples_ > 1 || !has(settings.effects, Effect::edges)) return;
  edges_ = std::make_unique<ShaderProgram>(gl, shaders, "edges");
  gl_.GenVertexArrays(1, &no_vertices_);
}

RenderTarget::~RenderTarget() {
  release();
  gl_.DeleteVertexArrays(1, &no_vertices_);
}

void RenderTarget::bind(int width, int height) {
  if (width != width_ || height != height_) {
    release();
    allocate(width, height);
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_);
  depth_is_read_ = false;
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
      throw InputError(
          fmt::format("OpenGL cannot create a frame of {} × {} pixels with {} samples each; choose a smaller "
                      "--size or a lower --quality",
                      width, height, samples_));
  };
  gl_.GenFramebuffers(1, &drawn_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_);
  if (samples_ > 1) {
    renderbuffer(color_, GL_RGBA8, samples_, GL_COLOR_ATTACHMENT0);
  } else {
    texture_ = smooth_texture();
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  }
  renderbuffer(depth_, GL_DEPTH_COMPONENT24, samples_, GL_DEPTH_ATTACHMENT);
  check_complete();
  gl_.GenFramebuffers(1, &resolved_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_);
  renderbuffer(picture_, GL_RGBA8, 1, GL_COLOR_ATTACHMENT0);
  check_complete();
}

GLuint RenderTarget::smooth_texture() const {
  GLuint id = 0;
  gl_.GenTextures(1, &id);
  gl_.BindTexture(GL_TEXTURE_2D, id);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  return id;
}

GLuint RenderTarget::depth() {
  if (depth_read_ == 0) {
    gl_.GenTextures(1, &depth_texture_);
    gl_.BindTexture(GL_TEXTURE_2D, depth_texture_);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, width_, height_, 0, GL_DEPTH_COMPONENT,
                   GL_UNSIGNED_INT, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    gl_.GenFramebuffers(1, &depth_read_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, depth_read_);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_texture_, 0);
    gl_.DrawBuffer(GL_NONE);
    gl_.ReadBuffer(GL_NONE);
  }
  if (depth_is_read_) return depth_texture_;
  depth_is_read_ = true;
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, depth_read_);
  gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  return depth_texture_;
}

GLuint RenderTarget::picture() {
  if (picture_read_ == 0) {
    picture_texture_ = smooth_texture();
    gl_.GenFramebuffers(1, &picture_read_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, picture_read_);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_texture_, 0);
  }
  gl_.Disable(GL_SCISSOR_TEST);
  copy(drawn_, picture_read_);
  return picture_texture_;
}

void RenderTarget::copy(GLuint from, GLuint to) const {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, from);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void RenderTarget::resolve() {
  gl_.Disable(GL_SCISSOR_TEST);
  copy(drawn_, resolved_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_);
  if (edges_) blend_steps();
}

void RenderTarget::show() const {
  copy(resolved_, 0);
}

void RenderTarget::copy_to(GLuint texture) const {
  GLuint target = 0;
  gl_.GenFramebuffers(1, &target);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, target);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  gl_.Disable(GL_SCISSOR_TEST);
  copy(resolved_, target);
  gl_.DeleteFramebuffers(1, &target);
}

// Drawn over the copy: the shader skips the pixels that are not at an edge.
void RenderTarget::blend_steps() const {
  gl_.Viewport(0, 0, width_, height_);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  edges_->use();
  edges_->set("picture", 0);
  gl_.BindVertexArray(no_vertices_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

Image RenderTarget::read() const {
  if (resolved_ == 0) throw std::logic_error("read_pixels was called before the first draw");
  Image image{width_, height_, {}};
  const std::size_t row = 3 * static_cast<std::size_t>(width_);
  image.rgb.resize(row * static_cast<std::size_t>(height_));
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  // Reads RGBA as stored: a conversion by the driver is slower than the loop below.
  std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  // OpenGL's rows start at the bottom.
  for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y) {
    const std::uint8_t* from =
        rgba.data() + 4 * static_cast<std::size_t>(width_) * (static_cast<std::size_t>(height_) - 1 - y);
    std::uint8_t* to = image.rgb.data() + y * row;
    for (int x = 0; x < width_; ++x, from += 4, to += 3) std::copy_n(from, 3, to);
  }
  return image;
}

void RenderTarget::release() {
  gl_.DeleteFramebuffers(1, &drawn_);
  gl_.DeleteFramebuffers(1, &resolved_);
  for (GLuint* buffer : {&color_, &depth_, &picture_}) gl_.DeleteRenderbuffers(1, buffer);
  for (const GLuint* read : {&depth_read_, &picture_read_}) gl_.DeleteFramebuffers(1, read);
  for (const GLuint* texture : {&texture_, &depth_texture_, &picture_texture_})
    gl_.DeleteTextures(1, texture);
  drawn_ = resolved_ = depth_read_ = depth_texture_ = picture_read_ = picture_texture_ = color_ = texture_ =
      depth_ = picture_ = 0;
  width_ = height_ = 0;
}

}  // namespace prosector
