#pragma once
// A second window, for people who watch beside the one who takes part: the same picture, of one eye. Private
// to client/render.

#include <functional>

#include "client/render/gl.h"
#include "client/render/window_context.h"

struct GLFWwindow;

namespace prosector {

class AudienceWindow {
 public:
  /// Opens the window. `main` is the window whose pictures it shows; its context is current, and is again
  /// after each call. Throws InputError where the monitor is missing or there can be no window.
  AudienceWindow(GLFWwindow* main, const GlContext& context, const Audience& audience);
  ~AudienceWindow();
  AudienceWindow(const AudienceWindow&) = delete;
  AudienceWindow& operator=(const AudienceWindow&) = delete;

  /// Shows what the main window's back buffer holds, which is that large (pixels).
  void show(int width, int height);
  /// Shows the picture of that size, which `copy` copies into the texture.
  void show(int width, int height, const std::function<void(unsigned texture)>& copy);
  /// Tells whether somebody closed it, or pressed Esc in it.
  bool closed() const;

 private:
  GLFWwindow* main_;
  GLFWwindow* window_;
  Audience audience_;
  Gl gl_;
  GLuint picture_ = 0;                        // the texture that both contexts share
  GLuint into_picture_ = 0, of_picture_ = 0;  // framebuffers with it: the main context's, the window's
  int width_ = 0, height_ = 0;                // of the picture, with all its eyes

  void make_picture(int width, int height);
  void take_window();
  void put();
};

}  // namespace prosector
