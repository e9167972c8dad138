#pragma once
// What is reckoned for several pixels at once, to be laid over the picture: a texture that is smaller than it
// by a whole number. Private to client/render.

#include "client/render/gl.h"
#include "client/view/draw_list.h"

namespace prosector {

class CoarseLayer {
 public:
  /// Makes a layer of `coarser` × `coarser` pixels a texel: `internal` and `format` are of glTexImage2D,
  /// bytes.
  CoarseLayer(const Gl& gl, int coarser, GLint internal, GLenum format);
  ~CoarseLayer();
  CoarseLayer(const CoarseLayer&) = delete;
  CoarseLayer& operator=(const CoarseLayer&) = delete;

  /// Makes it fit a picture of that size (pixels), binds its framebuffer, and fills it with one value in all
  /// channels. Binds textures to the active unit.
  void begin(int picture_width, int picture_height, float value);
  /// Returns where it has the camera's picture: x, y, width, height in texels.
  Eigen::Vector4i viewport_of(const DrawCamera& camera) const;
  GLuint texture() const { return texture_; }
  /// Returns how many pixels its width and height stand for.
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
