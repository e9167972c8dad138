#pragma once
// A second window for an audience: the main window's view of one eye. Private to client/render.

#include <functional>

#include "client/render/gl.h"
#include "client/render/window_context.h"

struct GLFWwindow;

namespace prosector {

class AudienceWindow {
 public:
  /// Opens the second window, for spectators. `main` is the window whose view is mirrored; its OpenGL context
  /// is current before and after each call. Throws InputError if the monitor is missing or the window cannot
  /// be created.
  AudienceWindow(GLFWwindow* main, const GlContext& context, const Audience& audience);
  ~AudienceWindow();
  AudienceWindow(const AudienceWindow&) = delete;
  AudienceWindow& operator=(const AudienceWindow&) = delete;

  /// Shows in the second window a copy of the main window's back buffer, whose size is `width` × `height`
  /// pixels.
  void show(int width, int height);
  /// Shows a frame of `width` × `height` pixels in the second window. `copy` must copy the frame into the
  /// OpenGL texture that it is called with.
  void show(int width, int height, const std::function<void(unsigned texture)>& copy);
  /// Returns whether a user closed the second window or pressed Esc in it.
  bool closed() const;

 private:
  GLFWwindow* main_;
  GLFWwindow* window_;
  Audience audience_;
  Gl gl_;
  GLuint picture_ = 0;  // texture shared by both contexts
  // Framebuffers with that texture: of the main context, of the window's context.
  GLuint into_picture_ = 0, of_picture_ = 0;
  int width_ = 0, height_ = 0;  // of the frame, with all its eyes

  void make_picture(int width, int height);
  void take_window();
  void put();
};

}  // namespace prosector
