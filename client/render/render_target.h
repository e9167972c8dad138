#pragma once
// The framebuffers that a picture is drawn into: multisampled, then resolved. Private to client/render.

#include "client/render/gl.h"
#include "client/render/image.h"

namespace prosector {

class RenderTarget {
 public:
  RenderTarget(const Gl& gl, int samples) : gl_(gl), samples_(samples) {}
  ~RenderTarget() { release(); }
  RenderTarget(const RenderTarget&) = delete;
  RenderTarget& operator=(const RenderTarget&) = delete;

  /// Makes it the framebuffer to draw to, of that size. Throws InputError when the driver refuses.
  void bind(int width, int height);
  /// Averages the samples; with a screen, also copies the picture to framebuffer 0.
  void resolve(bool has_screen);
  /// What was resolved last; throws std::logic_error before the first.
  Image read() const;

 private:
  void allocate(int width, int height);
  void release();

  const Gl& gl_;
  int samples_;
  int width_ = 0, height_ = 0;
  GLuint drawn_ = 0, color_ = 0, depth_ = 0;
  GLuint resolved_ = 0, picture_ = 0;
};

}  // namespace prosector
