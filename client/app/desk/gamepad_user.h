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
  /// Updates the state of the gamepad; nullopt means unplugged, which releases everything. Returns its
  /// presses and releases since the last call as events of the equivalent keys and mouse buttons.
  std::vector<WindowEvent> take(const std::optional<Gamepad>& now);

  bool is_there() const { return is_there_; }
  /// Returns how often the user has requested the list of parts with the gamepad since the last call.
  int take_list_calls() { return std::exchange(list_calls_, 0); }
  /// Returns the number of equivalent wheel notches since the last call: presses of the directional pad up
  /// minus presses down. They are not counted while the left trigger is pulled.
  int take_notches() { return std::exchange(notches_, 0); }

  /// Returns the direction in which the gamepad makes the view fly, each component −1 … 1: right, up and
  /// back. The left stick beyond its dead zone gives right and back, the bumpers give up and down. It is zero
  /// while the left trigger is pulled.
  Vec3 flight() const;
  /// Returns the right stick's deflection, by which the view rotates; zero while the left trigger is pulled.
  /// pointing() returns the deflection that then moves the pointer instead.
  PadStick turn() const;
  PadStick pointing() const;
  /// Returns how fast the gamepad zooms, −1 … 1, positive to zoom out: with the left trigger pulled, the left
  /// stick's deflection towards the user; otherwise 0.
  double zoom() const;
  /// Returns the direction in which the directional pad moves the hand: 1 for up (farther from the eye), −1
  /// for down. Returns 0 while it is not pressed, or while the left trigger is pulled.
  double reach() const;
  /// Returns the rotation of the wrist by the gamepad, with the left trigger pulled: `right` (bumpers) rolls
  /// the hand, `down` (directional pad) bends it. Zero otherwise.
  PadStick wrist() const;

 private:
  double bumpers() const;
  double cross() const;

  Gamepad pad_;
  bool is_there_ = false;
  int list_calls_ = 0, notches_ = 0;
};

}  // namespace prosector
