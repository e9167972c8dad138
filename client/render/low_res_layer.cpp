#include "client/render/low_res_layer.h"

namespace prosector {

LowResLayer::LowResLayer(const Gl& gl, int coarser, GLint internal, GLenum format)
    : gl_(gl), coarser_(coarser), internal_(internal), format_(format) {
  gl_.GenTextures(1, &texture_);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  allocate(1, 1);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
}

LowResLayer::~LowResLayer() {
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteTextures(1, &texture_);
}

void LowResLayer::allocate(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, internal_, width, height, 0, format_, GL_UNSIGNED_BYTE, nullptr);
}

void LowResLayer::begin(int picture_width, int picture_height, float value) {
  allocate(texels(picture_width), texels(picture_height));
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.ClearColor(value, value, value, value);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
}

Eigen::Vector4i LowResLayer::viewport_of(const DrawCamera& camera) const {
  return {camera.x / coarser_, camera.y / coarser_, texels(camera.width), texels(camera.height)};
}

}  // namespace prosector
