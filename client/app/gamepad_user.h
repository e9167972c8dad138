#pragma once
// What the user of a gamepad at the desk wants, in the words of mouse and keyboard.

#include <optional>
#include <vector>

#include "client/render/window_context.h"
#include "common/math.h"

namespace prosector {

class GamepadUser {
 public:
  /// Takes where the gamepad is now (nullopt: unplugged, all is let go). What was pressed and let go since
  /// the last call, as the keys and mouse buttons that do the same.
  std::vector<WindowEvent> take(const std::optional<Gamepad>& now);

  /// How far the sticks are pushed beyond their rest, each −1 … 1. To the right, up, back; up and down is by
  /// the bumpers.
  Vec3 flight() const;
  /// The right stick: turns the view, or with the left trigger pulled moves the pointer.
  PadStick turn() const;
  PadStick pointing() const;
  /// The cross, up: farther away.
  double reach() const;
  /// With the left trigger pulled: bumpers roll the hand, the cross bends it.
  PadStick wrist() const;

 private:
  double bumpers() const;
  double cross() const;

  Gamepad pad_;
};

}  // namespace prosector
