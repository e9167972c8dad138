#include "client/render/audience_window.h"

#include <algorithm>
#include <cmath>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "client/render/glfw_monitor.h"
#include "common/error.h"

namespace prosector {
namespace {

GLFWwindow* make_window(GLFWwindow* main, const Audience& audience) {
  GLFWmonitor* monitor = audience.monitor ? glfw_monitor(*audience.monitor) : nullptr;
  int width = audience.width, height = audience.height;
  if (monitor) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    width = mode->width;
    height = mode->height;
    // Keeps the audience's full-screen window open when the user clicks into the main window.
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
  }
  glfwWindowHint(GLFW_FOCUS_ON_SHOW, GLFW_FALSE);  // the main window keeps the keyboard focus
  GLFWwindow* window = glfwCreateWindow(width, height, "Prosector: audience", monitor, main);
  if (!window)
    throw InputError("cannot open a second window for spectators; start without --spectator-window");
  return window;
}

/// Makes a framebuffer of the current context with `texture` as its colour attachment.
GLuint framebuffer_of(const Gl& gl, GLuint texture) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_FRAMEBUFFER, name);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  return name;
}

}  // namespace

AudienceWindow::AudienceWindow(GLFWwindow* main, const GlContext& context, const Audience& audience)
    : main_(main), window_(make_window(main, audience)), audience_(audience), gl_(load_gl(context)) {
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int) {
    if (key == GLFW_KEY_ESCAPE && action == GLFW_PRESS) glfwSetWindowShouldClose(window, GLFW_TRUE);
  });
  glfwMakeContextCurrent(window_);
  // Only the main window waits for vertical sync; otherwise both would wait for each other.
  glfwSwapInterval(0);
  glfwMakeContextCurrent(main_);
}

AudienceWindow::~AudienceWindow() {
  gl_.DeleteFramebuffers(1, &into_picture_);
  gl_.DeleteTextures(1, &picture_);
  glfwDestroyWindow(window_);
  glfwMakeContextCurrent(main_);
}

bool AudienceWindow::closed() const {
  return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void AudienceWindow::show(int width, int height) {
  show(width, height, [this](unsigned) { take_window(); });
}

void AudienceWindow::show(int width, int height, const std::function<void(unsigned texture)>& copy) {
  make_picture(width, height);
  copy(picture_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.Finish();  // the other context sees the frame only after this
  glfwMakeContextCurrent(window_);
  put();
  glfwSwapBuffers(window_);
  glfwMakeContextCurrent(main_);
}

/// Resizes the shared texture, if needed.
void AudienceWindow::make_picture(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  if (picture_ == 0) gl_.GenTextures(1, &picture_);
  gl_.BindTexture(GL_TEXTURE_2D, picture_);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  if (into_picture_ == 0) into_picture_ = framebuffer_of(gl_, picture_);
}

/// Copies the back buffer into the shared texture.
void AudienceWindow::take_window() {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, into_picture_);
  gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

/// Shows the first eye's part of the frame as large as possible with its aspect ratio.
void AudienceWindow::put() {
  int across = 0, down = 0;
  glfwGetFramebufferSize(window_, &across, &down);
  if (across < 1 || down < 1) return;  // minimised
  const int eye = width_ / audience_.eyes;
  if (of_picture_ == 0) of_picture_ = framebuffer_of(gl_, picture_);
  const double aspect = audience_.aspect > 0 ? audience_.aspect : static_cast<double>(eye) / height_;
  const int width = std::min(across, static_cast<int>(std::lround(down * aspect)));
  const int height = std::min(down, static_cast<int>(std::lround(across / aspect)));
  const int x = (across - width) / 2, y = (down - height) / 2;
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl_.ClearColor(0, 0, 0, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, of_picture_);
  gl_.BlitFramebuffer(0, 0, eye, height_, x, y, x + width, y + height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

}  // namespace prosector
