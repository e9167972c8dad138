#pragma once
// A window with OpenGL 3.3 core and its input events, independent of the window library.

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/render/gamepad.h"
#include "client/render/gl_context.h"

namespace prosector {

/// Keys of a keyboard. Printing keys have the code of their upper-case ASCII character on a US keyboard, such
/// as 'W', '1' or a blank (other layouts: keyboard_layout.h). Other keys have codes from 256 on.
enum class Key : int {
  space = ' ',
  escape = 256,
  enter,
  tab,
  backspace,
  insert,
  del,
  right,
  left,
  down,
  up,
  page_up,
  page_down,
  home,
  end,
  shift,
  control,
  alt,
  f1,
  f2,
  f3,
  f4,
  f5,
  f6,
  f7,
  f8,
  f9,
  f10,
  f11,
  f12,
};
constexpr Key key_of(char printed) {
  return static_cast<Key>(printed);
}

enum class MouseButton { left, right, middle };

struct MouseMoved {
  double x, y;  // pixels of the frame, from its top left
};
struct MouseButtonEvent {
  MouseButton button;
  bool down;
};
struct WheelTurned {
  double x, y;  // notches; y > 0: away from the user
};
struct KeyEvent {
  Key key;
  bool down;
  bool repeat;  // auto-repeat of a held key
};
struct CharacterTyped {
  char32_t character;  // from the keyboard layout or an input method
};
struct Resized {
  int width, height;  // pixels of the frame
};
struct CloseRequested {};
struct GamepadMoved {
  std::optional<Gamepad> now;  // nullopt: disconnected
};

using WindowEvent = std::variant<MouseMoved, MouseButtonEvent, WheelTurned, KeyEvent, CharacterTyped, Resized,
                                 CloseRequested, GamepadMoved>;

/// Options of the view that spectators see: full screen on a monitor or in a window, which eye's part of the
/// frame, and its aspect ratio.
struct Audience {
  std::optional<int> monitor = {};  // full screen on this monitor, counted from 0; nullopt: a window
  int width = 800, height = 600;    // of the window, screen coordinates
  int eyes = 1;                     // side by side in the frame; the first is shown
  double aspect = 0;  // intended aspect ratio of one eye's view, width over height; 0: that of its pixels
};

class WindowContext : public GlContext {
 public:
  /// Returns the window's input events since the last call, in order; never waits. width() and height() are
  /// those of the last Resized event.
  virtual std::vector<WindowEvent> poll_events() = 0;
  /// Hides the pointer and confines it to the window, if `captured`, which allows unlimited relative motion.
  /// Otherwise releases it.
  virtual void capture_pointer(bool captured) = 0;
  /// Makes the window full screen on this monitor (0: the desktop's primary monitor). nullopt: restores the
  /// window at its previous position. Throws InputError that states the number of monitors if there is none
  /// with this number.
  virtual void set_full_screen(std::optional<int> monitor) = 0;
  /// Mirrors all following frames in a second window for an audience, until a user closes that window. Throws
  /// InputError if the monitor is missing or the window cannot be created.
  virtual void open_audience(const Audience& audience) = 0;
  /// Returns the desktop's scale factor of the display, by which text must be enlarged; 1 on a display of
  /// standard density.
  virtual double content_scale() const = 0;
};

/// Opens a window with an OpenGL context. Only one window can be open, in the main thread. Throws InputError
/// that states what is missing: a display (use an offscreen context instead), or OpenGL 3.3.
std::unique_ptr<WindowContext> make_window_context(int width, int height, const std::string& title);

}  // namespace prosector
