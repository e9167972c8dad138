#pragma once
// A texture for effects that are computed at reduced resolution and then applied to the frame. Its size is
// the frame's divided by a whole number. Private to client/render.

#include "client/render/gl.h"
#include "client/view/draw_list.h"

namespace prosector {

class LowResLayer {
 public:
  /// Creates the texture, with one texel per block of `coarser` × `coarser` pixels of the frame. `internal`
  /// and `format` are the parameters of glTexImage2D; the type is bytes.
  LowResLayer(const Gl& gl, int coarser, GLint internal, GLenum format);
  ~LowResLayer();
  LowResLayer(const LowResLayer&) = delete;
  LowResLayer& operator=(const LowResLayer&) = delete;

  /// Resizes the texture for a frame of the given size (pixels), binds it as the framebuffer to draw to, and
  /// clears all its channels to `value`. Changes the texture bound to the active unit.
  void begin(int picture_width, int picture_height, float value);
  /// Returns the part of the reduced-resolution texture that belongs to the camera's viewport: x, y, width
  /// and height in texels.
  Eigen::Vector4i viewport_of(const DrawCamera& camera) const;
  GLuint texture() const { return texture_; }
  /// Returns width and height, in pixels of the frame, of the area that the reduced-resolution texture
  /// covers. This is the frame's size rounded up to whole texels.
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
