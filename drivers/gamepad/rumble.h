#pragma once
// Vibration motors of a gamepad, as contact feedback for a desk user.

#include <memory>

namespace prosector {

/// Interface to the two vibration motors of a gamepad. One implementation uses the kernel's input devices;
/// tests have their own.
class RumbleMotors {
 public:
  virtual ~RumbleMotors() = default;
  /// Sets the levels, 0 … 1, of the strong low-frequency motor and of the weak high-frequency motor. They
  /// last until the next call, for half a second at most. Returns false once the gamepad is lost.
  virtual bool set(double strong, double weak) = 0;
};

/// Opens the first gamepad under /dev/input that has vibration motors and that the user may access. Returns
/// null if there is none.
std::unique_ptr<RumbleMotors> open_rumble();

/// Contact feedback by a gamepad's vibration motors. The strong motor follows the magnitude of the force on
/// the hand. The weak motor follows its rate of change, which is high at first contact.
class Rumble {
 public:
  explicit Rumble(std::unique_ptr<RumbleMotors> motors) : motors_(std::move(motors)) {}

  /// Updates the levels of the vibration motors for the magnitude of the force on the hand, N. `dt` is the
  /// time since the previous call, s. Returns false once the gamepad is lost.
  bool follow(double force, double dt);

 private:
  std::unique_ptr<RumbleMotors> motors_;
  double force_ = 0, burst_ = 0;              // N, smoothed magnitude; 0 … 1, level of the weak motor
  double strong_ = 0, weak_ = 0, since_ = 0;  // levels last sent, 0 … 1; s since then
};

}  // namespace prosector
