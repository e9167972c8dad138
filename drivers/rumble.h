#pragma once
// A gamepad's two motors, which let a hand at a desk know that it touches.

#include <memory>

namespace prosector {

/// Where the motors are driven: the kernel's, or a test's.
class RumbleMotors {
 public:
  virtual ~RumbleMotors() = default;
  /// Sets the strong and slow motor and the weak and quick one, 0 … 1 each, until the next call or for half a
  /// second. Returns false once the gamepad is gone.
  virtual bool set(double strong, double weak) = 0;
};

/// Opens the first gamepad under /dev/input that has motors and lets this user drive them; null: none does.
std::unique_ptr<RumbleMotors> open_rumble();

/// What motors do of a force on the hand: the strong one follows its size, the weak one its changes, as when
/// a touch begins.
class Rumble {
 public:
  explicit Rumble(std::unique_ptr<RumbleMotors> motors) : motors_(std::move(motors)) {}

  /// Takes the force on the hand, N, after dt s. Returns false once the gamepad is gone.
  bool follow(double force, double dt);

 private:
  std::unique_ptr<RumbleMotors> motors_;
  double force_ = 0, burst_ = 0;              // N, smoothed; 0 … 1
  double strong_ = 0, weak_ = 0, since_ = 0;  // as told last; s since then
};

}  // namespace prosector
