#pragma once
// The framebuffers that a picture is drawn into, and how its edges are made smooth. Private to client/render.

#include "client/render/renderer.h"
#include "client/render/shader_program.h"

namespace prosector {

class RenderTarget {
 public:
  RenderTarget(const Gl& gl, const std::filesystem::path& shaders, const RendererSettings& settings);
  ~RenderTarget();
  RenderTarget(const RenderTarget&) = delete;
  RenderTarget& operator=(const RenderTarget&) = delete;

  /// Makes this target the framebuffer to draw to, of that size. Throws InputError when the driver refuses.
  void bind(int width, int height);
  /// Returns the depth of the surfaces that were drawn since bind(), as a texture, copied when first asked
  /// for; bind_again() before drawing goes on.
  GLuint depth();
  /// Returns the picture that was drawn so far, as a texture; bind_again() before drawing goes on.
  GLuint picture();
  int width() const { return width_; }
  int height() const { return height_; }
  void bind_again() const { gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_); }
  /// Averages the samples, or blends the steps. What is drawn from now on goes over the finished picture,
  /// without depth.
  void resolve();
  /// Copies the picture to framebuffer 0, the screen.
  void show() const;
  /// Copies the picture into a texture of its size.
  void copy_to(GLuint texture) const;
  /// Reads what was resolved last; throws std::logic_error before the first.
  Image read() const;

 private:
  void allocate(int width, int height);
  GLuint smooth_texture() const;
  void release();
  void copy(GLuint from, GLuint to) const;
  void blend_steps() const;

  const Gl& gl_;
  int samples_;
  std::unique_ptr<ShaderProgram> edges_;  // null: edges are left as they are
  GLuint no_vertices_ = 0;
  int width_ = 0, height_ = 0;
  GLuint drawn_ = 0, color_ = 0, texture_ = 0, depth_ = 0;  // color_ with several samples, else texture_
  GLuint resolved_ = 0, picture_ = 0;
  GLuint depth_read_ = 0, depth_texture_ = 0;      // 0 until asked for
  bool depth_is_read_ = false;                     // since bind()
  GLuint picture_read_ = 0, picture_texture_ = 0;  // 0 until asked for
};

}  // namespace prosector
