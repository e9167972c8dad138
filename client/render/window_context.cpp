#include "client/render/window_context.h"

#include <fmt/format.h>

#include <array>
#include <optional>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "common/error.h"

namespace prosector {
namespace {

std::string last_glfw_error() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description ? description : "no reason given";
}

std::optional<Key> key_from_glfw(int key) {
  struct Row {
    int glfw;
    Key ours;
  };
  static constexpr std::array<Row, 20> rows = {{{GLFW_KEY_ESCAPE, Key::escape},
                                                {GLFW_KEY_ENTER, Key::enter},
                                                {GLFW_KEY_KP_ENTER, Key::enter},
                                                {GLFW_KEY_TAB, Key::tab},
                                                {GLFW_KEY_BACKSPACE, Key::backspace},
                                                {GLFW_KEY_INSERT, Key::insert},
                                                {GLFW_KEY_DELETE, Key::del},
                                                {GLFW_KEY_RIGHT, Key::right},
                                                {GLFW_KEY_LEFT, Key::left},
                                                {GLFW_KEY_DOWN, Key::down},
                                                {GLFW_KEY_UP, Key::up},
                                                {GLFW_KEY_PAGE_UP, Key::page_up},
                                                {GLFW_KEY_PAGE_DOWN, Key::page_down},
                                                {GLFW_KEY_HOME, Key::home},
                                                {GLFW_KEY_END, Key::end},
                                                {GLFW_KEY_LEFT_SHIFT, Key::shift},
                                                {GLFW_KEY_RIGHT_SHIFT, Key::shift},
                                                {GLFW_KEY_LEFT_CONTROL, Key::control},
                                                {GLFW_KEY_RIGHT_CONTROL, Key::control},
                                                {GLFW_KEY_LEFT_ALT, Key::alt}}};
  if (key >= ' ' && key <= '~') return static_cast<Key>(key);
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
    return static_cast<Key>(static_cast<int>(Key::f1) + key - GLFW_KEY_F1);
  for (const Row& row : rows)
    if (row.glfw == key) return row.ours;
  return std::nullopt;
}

class GlfwWindow final : public WindowContext {
 public:
  GlfwWindow(int width, int height, const std::string& title) {
    check_picture_size(width, height);
    if (!glfwInit())
      throw InputError(
          fmt::format("no window: {}; start it in a desktop (DISPLAY), or choose an offscreen display",
                      last_glfw_error()));
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the renderer has framebuffers of its own
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!window_) {
      const std::string reason = last_glfw_error();
      glfwTerminate();
      throw InputError(fmt::format("no window with OpenGL 3.3 core: {}", reason));
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwGetFramebufferSize(window_, &width_, &height_);
    listen();
  }
  ~GlfwWindow() override {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  void* proc(const char* name) const override { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }
  int width() const override { return width_; }
  int height() const override { return height_; }
  bool has_screen() const override { return true; }
  void present() override { glfwSwapBuffers(window_); }
  std::string description() const override { return describe_gl(*this, "window"); }

  std::vector<WindowEvent> poll_events() override {
    events_.clear();
    glfwPollEvents();
    return std::move(events_);
  }
  void capture_pointer(bool captured) override {
    glfwSetInputMode(window_, GLFW_CURSOR, captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
  }

  void set_full_screen(std::optional<int> monitor) override {
    const bool fills = glfwGetWindowMonitor(window_) != nullptr;
    if (!monitor) {
      if (fills)
        glfwSetWindowMonitor(window_, nullptr, place_[0], place_[1], place_[2], place_[3], GLFW_DONT_CARE);
      return;
    }
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    if (*monitor < 0 || *monitor >= count)
      throw InputError(
          fmt::format("monitor {}: there {} {}, counted from 0", *monitor, count == 1 ? "is" : "are", count));
    if (!fills) {
      glfwGetWindowPos(window_, &place_[0], &place_[1]);
      glfwGetWindowSize(window_, &place_[2], &place_[3]);
    }
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[*monitor]);
    glfwSetWindowMonitor(window_, monitors[*monitor], 0, 0, mode->width, mode->height, mode->refreshRate);
  }

 private:
  static GlfwWindow& self(GLFWwindow* window) {
    return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
  }

  void listen() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) { self(w).pointer_moved(x, y); });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
      if (button <= GLFW_MOUSE_BUTTON_MIDDLE)
        self(w).events_.push_back(MouseButtonEvent{static_cast<MouseButton>(button), action == GLFW_PRESS});
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
      self(w).events_.push_back(WheelTurned{x, y});
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int) {
      if (const auto ours = key_from_glfw(key))
        self(w).events_.push_back(KeyEvent{*ours, action != GLFW_RELEASE, action == GLFW_REPEAT});
    });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int width, int height) {
      if (width < 1 || height < 1) return;  // minimised: keep drawing the old size
      self(w).width_ = width;
      self(w).height_ = height;
      self(w).events_.push_back(Resized{width, height});
    });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { self(w).events_.push_back(CloseRequested{}); });
  }

  // GLFW counts in screen coordinates, which on some desktops are larger than pixels.
  void pointer_moved(double x, double y) {
    int window_width = 1, window_height = 1;
    glfwGetWindowSize(window_, &window_width, &window_height);
    if (window_width < 1 || window_height < 1) return;
    events_.push_back(MouseMoved{x * width_ / window_width, y * height_ / window_height});
  }

  static_assert(GLFW_MOUSE_BUTTON_LEFT == static_cast<int>(MouseButton::left));
  static_assert(GLFW_MOUSE_BUTTON_RIGHT == static_cast<int>(MouseButton::right));
  static_assert(GLFW_MOUSE_BUTTON_MIDDLE == static_cast<int>(MouseButton::middle));

  GLFWwindow* window_ = nullptr;
  int width_ = 0, height_ = 0;
  std::array<int, 4> place_{};  // as a window: x, y, width, height in screen coordinates
  std::vector<WindowEvent> events_;
};

}  // namespace

std::unique_ptr<WindowContext> make_window_context(int width, int height, const std::string& title) {
  return std::make_unique<GlfwWindow>(width, height, title);
}

}  // namespace prosector
