#include "client/render/window_context.h"

#include <array>
#include <optional>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "client/render/audience_window.h"
#include "client/render/glfw_monitor.h"
#include "client/render/glfw_window.h"
#include "client/render/keyboard_layout.h"

namespace prosector {
namespace {

std::optional<Key> key_from_glfw(int key, int scancode) {
  struct Row {
    int glfw;
    Key ours;
  };
  static constexpr std::array<Row, 22> rows = {{{GLFW_KEY_ESCAPE, Key::escape},
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
                                                {GLFW_KEY_LEFT_ALT, Key::alt},
                                                {GLFW_KEY_KP_ADD, key_of('=')},
                                                {GLFW_KEY_KP_SUBTRACT, key_of('-')}}};
  if (key >= ' ' && key <= '~') {
    const char* printed = glfwGetKeyName(key, scancode);
    return key_meant(static_cast<Key>(key), printed != nullptr ? printed : "");
  }
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
    return static_cast<Key>(static_cast<int>(Key::f1) + key - GLFW_KEY_F1);
  for (const Row& row : rows)
    if (row.glfw == key) return row.ours;
  return std::nullopt;
}

/// Returns the state of the first joystick that is a gamepad.
std::optional<Gamepad> gamepad_from_glfw() {
  static constexpr std::array<int, pad_buttons> buttons = {
      GLFW_GAMEPAD_BUTTON_A,           GLFW_GAMEPAD_BUTTON_B,           GLFW_GAMEPAD_BUTTON_X,
      GLFW_GAMEPAD_BUTTON_Y,           GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER,
      GLFW_GAMEPAD_BUTTON_BACK,        GLFW_GAMEPAD_BUTTON_START,       GLFW_GAMEPAD_BUTTON_LEFT_THUMB,
      GLFW_GAMEPAD_BUTTON_RIGHT_THUMB, GLFW_GAMEPAD_BUTTON_DPAD_UP,     GLFW_GAMEPAD_BUTTON_DPAD_RIGHT,
      GLFW_GAMEPAD_BUTTON_DPAD_DOWN,   GLFW_GAMEPAD_BUTTON_DPAD_LEFT};
  for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
    GLFWgamepadstate state;
    if (!glfwGetGamepadState(joystick, &state)) continue;
    const auto axis = [&](int which) { return static_cast<double>(state.axes[which]); };
    Gamepad pad;
    pad.left = {axis(GLFW_GAMEPAD_AXIS_LEFT_X), axis(GLFW_GAMEPAD_AXIS_LEFT_Y)};
    pad.right = {axis(GLFW_GAMEPAD_AXIS_RIGHT_X), axis(GLFW_GAMEPAD_AXIS_RIGHT_Y)};
    pad.left_trigger = (axis(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER) + 1) / 2;  // −1 at rest
    pad.right_trigger = (axis(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER) + 1) / 2;
    for (std::size_t k = 0; k < pad_buttons; ++k) pad.down[k] = state.buttons[buttons[k]] == GLFW_PRESS;
    return pad;
  }
  return std::nullopt;
}

class GlfwWindow final : public WindowContext {
 public:
  GlfwWindow(int width, int height, const std::string& title) {
    check_picture_size(width, height);
    start_glfw();
    window_ = open_glfw_window(width, height, title);
    glfwSwapInterval(1);
    glfwGetFramebufferSize(window_, &width_, &height_);
    listen();
  }
  ~GlfwWindow() override {
    audience_.reset();
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  void* proc(const char* name) const override { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }
  int width() const override { return width_; }
  int height() const override { return height_; }
  bool has_screen() const override { return true; }
  void present() override {
    if (audience_ && audience_->closed()) audience_.reset();
    if (audience_) audience_->show(width_, height_);
    glfwSwapBuffers(window_);
  }
  std::string description() const override { return describe_gl(*this, "window"); }

  std::vector<WindowEvent> poll_events() override {
    glfwPollEvents();
    if (const auto pad = gamepad_from_glfw(); pad || has_gamepad_) {
      has_gamepad_ = pad.has_value();
      events_.push_back(GamepadMoved{pad});
    }
    return std::exchange(events_, {});
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
    GLFWmonitor* wanted = glfw_monitor(*monitor);
    if (!fills) {
      glfwGetWindowPos(window_, &place_[0], &place_[1]);
      glfwGetWindowSize(window_, &place_[2], &place_[3]);
    }
    const GLFWvidmode* mode = glfwGetVideoMode(wanted);
    glfwSetWindowMonitor(window_, wanted, 0, 0, mode->width, mode->height, mode->refreshRate);
  }

  void open_audience(const Audience& audience) override {
    audience_ = std::make_unique<AudienceWindow>(window_, *this, audience);
  }

  double content_scale() const override {
    float across = 1, down = 1;
    glfwGetWindowContentScale(window_, &across, &down);
    return static_cast<double>(across);
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
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int) {
      if (const auto ours = key_from_glfw(key, scancode))
        self(w).events_.push_back(KeyEvent{*ours, action != GLFW_RELEASE, action == GLFW_REPEAT});
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned character) {
      self(w).events_.push_back(CharacterTyped{static_cast<char32_t>(character)});
    });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int width, int height) {
      if (width < 1 || height < 1) return;  // minimised: keep the old size
      self(w).width_ = width;
      self(w).height_ = height;
      self(w).events_.push_back(Resized{width, height});
    });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { self(w).events_.push_back(CloseRequested{}); });
  }

  // GLFW reports screen coordinates, which on some desktops are larger than pixels.
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
  std::array<int, 4> place_{};  // in windowed mode: x, y, width, height in screen coordinates
  bool has_gamepad_ = false;
  std::vector<WindowEvent> events_;
  std::unique_ptr<AudienceWindow> audience_;
};

}  // namespace

std::unique_ptr<WindowContext> make_window_context(int width, int height, const std::string& title) {
  return std::make_unique<GlfwWindow>(width, height, title);
}

}  // namespace prosector
