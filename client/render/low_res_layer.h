#pragma once
// A texture for effects that are computed at reduced resolution and then applied to the frame. Its size is
// the frame's divided by a whole number. Private to client/render.

#include "client/render/gl.h"
#include "client/view/draw_list.h"

namespace prosector {

class LowResLayer {
 public:
  /// Makes a layer with one texel per `coarser` × `coarser` pixels. `internal` and `format` are the formats
  /// of glTexImage2D; the type is bytes.
  LowResLayer(const Gl& gl, int coarser, GLint internal, GLenum format);
  ~LowResLayer();
  LowResLayer(const LowResLayer&) = delete;
  LowResLayer& operator=(const LowResLayer&) = delete;

  /// Resizes the layer for a frame of the given size (pixels), binds its framebuffer, and clears all channels
  /// to `value`. Binds textures to the active unit.
  void begin(int picture_width, int picture_height, float value);
  /// Returns the camera's viewport in the layer: x, y, width, height in texels.
  Eigen::Vector4i viewport_of(const DrawCamera& camera) const;
  GLuint texture() const { return texture_; }
  /// Returns how many pixels the layer covers.
  Eigen::Vector2i pixels() const { return {coarser_ * width_, coarser_ * height_}; }

 private:
  const Gl& gl_;
  int coarser_;
  GLint internal_;
  GLenum format_;
  GLuint texture_ = 0, framebuffer_ = 0;
  int width_ = 0, height_ = 0;  // texels

  int texels(int pixels) const { return (pixels + coarser_ - 1) / coarser_; }
  void allocate(int width, int height);
};

}  // namespace prosector
