#pragma once
// Vibration motors of a gamepad, as contact feedback for a desk user.

#include <memory>

namespace prosector {

/// Interface of the motors: the kernel's, or a test's.
class RumbleMotors {
 public:
  virtual ~RumbleMotors() = default;
  /// Sets the strong low-frequency motor and the weak high-frequency motor, 0 … 1 each, until the next call
  /// or for half a second. Returns false once the gamepad is lost.
  virtual bool set(double strong, double weak) = 0;
};

/// Opens the first gamepad under /dev/input that has motors and that the user may access. Returns null if
/// there is none.
std::unique_ptr<RumbleMotors> open_rumble();

/// Converts the force on the hand to motor levels. The strong motor follows the magnitude, the weak one its
/// rate of change, such as at first contact.
class Rumble {
 public:
  explicit Rumble(std::unique_ptr<RumbleMotors> motors) : motors_(std::move(motors)) {}

  /// Updates the motors for a force on the hand, N, `dt` s after the previous call. Returns false once the
  /// gamepad is lost.
  bool follow(double force, double dt);

 private:
  std::unique_ptr<RumbleMotors> motors_;
  double force_ = 0, burst_ = 0;              // N, smoothed magnitude; 0 … 1, level of the weak motor
  double strong_ = 0, weak_ = 0, since_ = 0;  // levels last sent, 0 … 1; s since then
};

}  // namespace prosector
