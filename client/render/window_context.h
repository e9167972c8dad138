#pragma once
// A window with OpenGL 3.3 core and what people do in it, in types of our own.

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/render/gamepad.h"
#include "client/render/gl_context.h"

namespace prosector {

/// The keys of a keyboard. Those that print are their upper-case ASCII character on a US keyboard: 'W', '1',
/// a blank (on others: keyboard_layout.h). Others follow.
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
  double x, y;  // pixels of the picture, from its top left
};
struct MouseButtonEvent {
  MouseButton button;
  bool down;
};
struct WheelTurned {
  double x, y;  // notches; y > 0: away from the person
};
struct KeyEvent {
  Key key;
  bool down;
  bool repeat;  // a held key's repeated press
};
struct CharacterTyped {
  char32_t character;  // as the keyboard's layout and input methods make it
};
struct Resized {
  int width, height;  // pixels of the picture
};
struct CloseRequested {};
struct GamepadMoved {
  std::optional<Gamepad> now;  // nullopt: unplugged
};

using WindowEvent = std::variant<MouseMoved, MouseButtonEvent, WheelTurned, KeyEvent, CharacterTyped, Resized,
                                 CloseRequested, GamepadMoved>;

/// What people see who watch beside the one who takes part.
struct Audience {
  std::optional<int> monitor = {};  // to fill, counted from 0; nullopt: a window
  int width = 800, height = 600;    // of the window, screen coordinates
  int eyes = 1;                     // side by side in the picture; the first is shown
  double aspect = 0;  // of one eye's picture, width over height as it is meant to be seen; 0: of its pixels
};

class WindowContext : public GlContext {
 public:
  /// Returns what happened since the last call, in order; never waits. width() and height() are those of the
  /// last Resized.
  virtual std::vector<WindowEvent> poll_events() = 0;
  /// Hides the pointer and keeps it inside, so that moving has no end, or lets it go.
  virtual void capture_pointer(bool captured) = 0;
  /// Fills this monitor, counted from 0, the desktop's first; nullopt: a window where it was before. Throws
  /// InputError saying how many there are when there is none of that number.
  virtual void set_full_screen(std::optional<int> monitor) = 0;
  /// Shows every picture from now on in a second window, too, until somebody closes that. Throws InputError
  /// as set_full_screen() does, and where there can be no window.
  virtual void open_audience(const Audience& audience) = 0;
  /// Returns how many times as fine as usual the desktop says that its display is: what is read is to be
  /// drawn as many times larger.
  virtual double content_scale() const = 0;
};

/// Opens a window: only one at a time, in the main thread. Throws InputError saying what is missing: no
/// display (use an offscreen one), or no OpenGL 3.3.
std::unique_ptr<WindowContext> make_window_context(int width, int height, const std::string& title);

}  // namespace prosector
