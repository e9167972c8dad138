#pragma once
// A simulated VRPN server with an arm: bytes in both directions, and a servo loop that renders force fields.
// The owner advances its time.

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <string>

#include "drivers/protocols/vrpn_messages.h"
#include "twins/arms/held_arm.h"

namespace prosector {

struct VrpnTwinOptions : HeldArmOptions {
  std::string name = "Arm0";
  std::uint64_t seed = 1;
  double garbage = 0;  // fraction of reports with random numbers
};

class VrpnTwin {
 public:
  VrpnTwin(VrpnTwinOptions options, std::int64_t now_ns);

  /// Processes bytes that the client sent to the simulated VRPN server, such as force fields.
  void receive(std::span<const std::uint8_t> bytes);
  /// Advances the simulated arm to the time `now_ns`. Returns the bytes to send: reports for a client that
  /// has sent its cookie, otherwise none.
  vrpn::Bytes advance(std::int64_t now_ns);
  /// Ends the client's session: the motors are switched off and the simulated hand releases the arm.
  void hang_up();
  /// Sets an error code of the VRPN message Force_Error, which is sent with the next report.
  void queue_error_code(std::int32_t code) { queued_error_code_ = code; }
  /// Presses or releases the button of the simulated arm. The next report contains the change.
  void press(bool pressed) { button_ = pressed; }
  void go_on(std::int64_t now_ns) { arm_.go_on(now_ns); }

  const HeldArm& arm() const { return arm_; }
  bool has_client() const { return reader_.greeted(); }
  std::uint64_t bad_messages() const { return bad_messages_; }

  double garbage;

 private:
  void greet(vrpn::Bytes& out) const;

  std::string name_;
  HeldArm arm_;
  std::mt19937_64 random_;
  std::int64_t now_ns_;
  vrpn::Reader reader_;
  bool named_ = false;
  std::optional<vrpn::ForceField> field_;
  std::optional<std::int32_t> queued_error_code_;
  std::optional<bool> button_;
  std::uint64_t bad_messages_ = 0;
};

}  // namespace prosector
