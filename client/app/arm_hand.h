#pragma once
// A user's hand that a haptic arm moves: between the servo's thread, the network's and who sends inputs.

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "client/haptics/servo_thread.h"
#include "common/messages.h"
#include "drivers/client_config.h"

namespace prosector {

class ArmHand {
 public:
  /// Opens the arm that the configuration names and starts its servo. Throws InputError for an address that
  /// is none; an arm that is away is no error.
  explicit ArmHand(const ArmSettings& settings);

  std::size_t hand() const { return settings_.hand; }
  /// Takes a message of the server. Called by the network's thread.
  void received(const FeltPlanes& felt, ParticipantId participant);
  /// Writes the hand as the arm has it into the input. Returns what the arm does, to be sent along.
  ArmForce fill(HandInput& input);
  /// Returns what its buttons asked for since the last call: the first one takes hold, or lets go.
  std::vector<CommandKind> take_wishes();
  /// Returns a line for people when its state changed since the last call.
  std::vector<std::string> take_news();
  ServoThread& servo() { return servo_; }
  /// Returns what the server counts of the hand's energy, as it told last.
  EnergyBook far_end() const { return {far_taken_, far_given_}; }

 private:
  ArmSettings settings_;
  ServoThread servo_;
  std::uint64_t sequence_ = 0;
  std::uint32_t buttons_ = 0;
  bool holds_ = false;
  std::vector<CommandKind> wishes_;
  DeviceHealth told_ = DeviceHealth::connecting;
  std::string told_message_;
  ServoView view_;
  std::atomic<std::uint64_t> felt_tick_ = 0;           // of the newest message
  std::atomic<double> far_taken_ = 0, far_given_ = 0;  // J
};

}  // namespace prosector
