#pragma once
// What the user of a gamepad at the desk wants, in the words of mouse and keyboard.

#include <optional>
#include <utility>
#include <vector>

#include "client/render/window_context.h"
#include "common/math.h"

namespace prosector {

class GamepadUser {
 public:
  /// Takes where the gamepad is now (nullopt: unplugged, all is let go). Returns what was pressed and let go
  /// since the last call, as the keys and mouse buttons that do the same.
  std::vector<WindowEvent> take(const std::optional<Gamepad>& now);

  bool is_there() const { return is_there_; }
  /// Returns how often the list of parts was asked for since the last call.
  int take_list_calls() { return std::exchange(list_calls_, 0); }
  /// Returns, without the left trigger, how often the cross was pressed up, less how often down, since the
  /// last call.
  int take_notches() { return std::exchange(notches_, 0); }

  /// Returns how far the sticks are pushed beyond their rest, each −1 … 1: to the right, up, back. Up and
  /// down is by the bumpers.
  Vec3 flight() const;
  /// Returns the right stick: turns the view, or with the left trigger pulled moves the pointer.
  PadStick turn() const;
  PadStick pointing() const;
  /// Returns, with the left trigger pulled, how far the left stick is pushed back, −1 … 1: away from what is
  /// seen. It moves nothing then.
  double zoom() const;
  /// Returns how the cross is pressed, up: farther away.
  double reach() const;
  /// Returns, with the left trigger pulled, the turn of the wrist: bumpers roll the hand, the cross bends it.
  PadStick wrist() const;

 private:
  double bumpers() const;
  double cross() const;

  Gamepad pad_;
  bool is_there_ = false;
  int list_calls_ = 0, notches_ = 0;
};

}  // namespace prosector
