#pragma once
// Gamepad of a desk user, translated into keyboard and mouse input.

#include <optional>
#include <utility>
#include <vector>

#include "client/render/window_context.h"
#include "common/math.h"

namespace prosector {

class GamepadUser {
 public:
  /// Updates the gamepad state (nullopt: unplugged, everything is released). Returns the presses and releases
  /// since the last call as events of the equivalent keys and mouse buttons.
  std::vector<WindowEvent> take(const std::optional<Gamepad>& now);

  bool is_there() const { return is_there_; }
  /// Returns how often the list of parts was requested since the last call.
  int take_list_calls() { return std::exchange(list_calls_, 0); }
  /// Returns wheel notches: presses of the cross up minus presses down since the last call, not counted while
  /// the left trigger is pulled.
  int take_notches() { return std::exchange(notches_, 0); }

  /// Returns the flight direction, each component −1 … 1: right, up, back. The left stick beyond its dead
  /// zone gives right and back, the bumpers give up and down.
  Vec3 flight() const;
  /// Returns the right stick's deflection: it rotates the view or, with the left trigger pulled, moves the
  /// pointer (pointing()).
  PadStick turn() const;
  PadStick pointing() const;
  /// Returns, with the left trigger pulled, the left stick's deflection backwards, −1 … 1: zooms out. The
  /// stick then does not fly.
  double zoom() const;
  /// Returns 1 for the cross pressed up (farther away), −1 for down.
  double reach() const;
  /// Returns, with the left trigger pulled, the wrist's rotation: bumpers roll the hand, the cross bends it.
  PadStick wrist() const;

 private:
  double bumpers() const;
  double cross() const;

  Gamepad pad_;
  bool is_there_ = false;
  int list_calls_ = 0, notches_ = 0;
};

}  // namespace prosector
