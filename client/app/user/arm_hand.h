#pragma once
// A user's hand that a haptic arm moves. Passes data between the servo thread, the network thread and the
// thread that sends inputs.

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "client/haptics/servo_thread.h"
#include "common/commands.h"
#include "common/hand_messages.h"
#include "common/ids.h"
#include "drivers/config/client_config.h"

namespace prosector {

class ArmHand {
 public:
  /// Opens the haptic arm that the settings name, and starts its servo thread. Throws InputError for an
  /// invalid address; an arm that is not connected is not an error.
  explicit ArmHand(const ArmSettings& settings);

  std::size_t hand() const { return settings_.hand; }
  /// Passes the contact planes (local models of the contact forces) of a server message to the arm's servo
  /// thread, if they are for this user's hand. Called on the network thread.
  void received(const FeltPlanes& felt, ParticipantId participant);
  /// Writes the hand pose and buttons that the arm reports into the input to be sent. Returns the arm's force
  /// and energy balance, to be published with the input.
  ArmForce fill(HandInput& input);
  /// Returns and removes the commands that the arm's buttons have requested since the last call: the first
  /// button alternates between grasp and release.
  std::vector<CommandBody> take_wishes();
  /// Returns a status line of the arm for the user if its state changed since the last call, else no line.
  std::vector<std::string> take_news();
  ServoThread& servo() { return servo_; }
  /// Returns the energy that the simulation has taken from and given to the user's hand so far, J, as the
  /// server last reported it.
  EnergyBook server_energy() const { return {far_taken_, far_given_}; }

 private:
  ArmSettings settings_;
  ServoThread servo_;
  std::uint64_t sequence_ = 0;
  std::uint32_t buttons_ = 0;
  bool holds_ = false;
  std::vector<CommandBody> wishes_;
  DeviceHealth reported_health_ = DeviceHealth::connecting;
  std::string reported_message_;
  ServoView view_;
  std::atomic<std::uint64_t> felt_tick_ = 0;           // tick of the newest message
  std::atomic<double> far_taken_ = 0, far_given_ = 0;  // J, as last reported by the server
};

}  // namespace prosector
