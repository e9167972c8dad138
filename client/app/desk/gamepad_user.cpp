#include "client/app/desk/gamepad_user.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace prosector {
namespace {

constexpr double rest =
    0.15;  // dead zone, fraction of a stick's deflection: worn sticks don't return to the centre
constexpr double pulled = 0.5;

struct KeyRow {
  PadButton button;
  Key key;
};
constexpr std::array<KeyRow, 9> key_rows = {{{PadButton::west, key_of('P')},
                                             {PadButton::east, key_of('Z')},
                                             {PadButton::north, Key::tab},
                                             {PadButton::start, key_of('H')},
                                             {PadButton::back, key_of('I')},
                                             {PadButton::left_stick, Key::home},
                                             {PadButton::right_stick, key_of('F')},
                                             {PadButton::left, key_of('V')},
                                             {PadButton::right, key_of('C')}}};

PadStick beyond_rest(const PadStick& stick) {
  const double length = std::hypot(stick.right, stick.down);
  if (!(length > rest)) return {};
  const double wanted = std::min((length - rest) / (1 - rest), 1.0) / length;
  return {wanted * stick.right, wanted * stick.down};
}

bool aims(const Gamepad& pad) {
  return pad.left_trigger > pulled;
}

bool works(const Gamepad& pad) {
  return pad.right_trigger > pulled || pad.is_down(PadButton::south);
}

}  // namespace

std::vector<WindowEvent> GamepadUser::take(const std::optional<Gamepad>& now) {
  is_there_ = now.has_value();
  const Gamepad before = std::exchange(pad_, now.value_or(Gamepad{}));
  std::vector<WindowEvent> out;
  const auto pressed = [&](PadButton button) { return pad_.is_down(button) && !before.is_down(button); };
  if (aims(pad_) && pressed(PadButton::start)) ++list_calls_;
  if (!aims(pad_)) notches_ += (pressed(PadButton::up) ? 1 : 0) - (pressed(PadButton::down) ? 1 : 0);
  for (const auto& [button, plain] : key_rows) {
    if (button == PadButton::start && aims(pad_)) continue;
    const Key key = button == PadButton::back && aims(pad_) ? key_of('N') : plain;
    if (pad_.is_down(button) != before.is_down(button))
      out.push_back(KeyEvent{key, pad_.is_down(button), false});
  }
  if (works(pad_) != works(before)) out.push_back(MouseButtonEvent{MouseButton::left, works(pad_)});
  return out;
}

/// Returns 1 for the right bumper, −1 for the left.
double GamepadUser::bumpers() const {
  return (pad_.is_down(PadButton::right_bumper) ? 1 : 0) - (pad_.is_down(PadButton::left_bumper) ? 1 : 0);
}

/// Returns 1 for up, −1 for down.
double GamepadUser::cross() const {
  return (pad_.is_down(PadButton::up) ? 1 : 0) - (pad_.is_down(PadButton::down) ? 1 : 0);
}

Vec3 GamepadUser::flight() const {
  if (aims(pad_)) return Vec3::Zero();
  const PadStick stick = beyond_rest(pad_.left);
  return {stick.right, bumpers(), stick.down};
}

double GamepadUser::zoom() const {
  return aims(pad_) ? beyond_rest(pad_.left).down : 0;
}

PadStick GamepadUser::turn() const {
  return aims(pad_) ? PadStick{} : beyond_rest(pad_.right);
}

PadStick GamepadUser::pointing() const {
  return aims(pad_) ? beyond_rest(pad_.right) : PadStick{};
}

double GamepadUser::reach() const {
  return aims(pad_) ? 0 : cross();
}

PadStick GamepadUser::wrist() const {
  return aims(pad_) ? PadStick{bumpers(), -cross()} : PadStick{};
}

}  // namespace prosector
