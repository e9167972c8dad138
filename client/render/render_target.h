#pragma once
// The framebuffers of a frame, with antialiasing. Private to client/render.

#include "client/render/renderer.h"
#include "client/render/shader_program.h"

namespace prosector {

class RenderTarget {
 public:
  RenderTarget(const Gl& gl, const std::filesystem::path& shaders, const RendererSettings& settings);
  ~RenderTarget();
  RenderTarget(const RenderTarget&) = delete;
  RenderTarget& operator=(const RenderTarget&) = delete;

  /// Binds the frame's framebuffer to draw to, and resizes it to `width` × `height` pixels if needed. Throws
  /// InputError if the driver cannot create it.
  void bind(int width, int height);
  /// Returns the depth of the surfaces drawn so far as a texture. It is copied only at the first call after
  /// bind(). Call bind_again() before drawing further.
  GLuint depth();
  /// Returns a copy of the colours drawn so far as a texture. Call bind_again() before drawing further.
  GLuint picture();
  int width() const { return width_; }
  int height() const { return height_; }
  void bind_again() const { gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_); }
  /// Finishes the frame: averages the samples of multisampling, or smooths edges by post-processing. Later
  /// drawing, for instance of texts, goes over the finished frame, without depth.
  void resolve();
  /// Copies the frame that resolve() finished to framebuffer 0, the window.
  void show() const;
  /// Copies the frame that resolve() finished into an OpenGL texture of the same size.
  void copy_to(GLuint texture) const;
  /// Returns the frame that resolve() finished last, read back from the GPU. Throws std::logic_error if there
  /// is none.
  Image read() const;

 private:
  void allocate(int width, int height);
  GLuint smooth_texture() const;
  void release();
  void copy(GLuint from, GLuint to) const;
  void blend_steps() const;

  const Gl& gl_;
  int samples_;
  std::unique_ptr<ShaderProgram> edges_;  // null: no edge smoothing
  GLuint no_vertices_ = 0;
  int width_ = 0, height_ = 0;
  GLuint drawn_ = 0, color_ = 0, texture_ = 0, depth_ = 0;  // color_ with multisampling, else texture_
  GLuint resolved_ = 0, picture_ = 0;
  GLuint depth_read_ = 0, depth_texture_ = 0;      // 0 until requested
  bool depth_is_read_ = false;                     // since bind()
  GLuint picture_read_ = 0, picture_texture_ = 0;  // 0 until requested
};

}  // namespace prosector
