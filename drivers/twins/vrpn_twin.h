#pragma once
// A simulated VRPN server with an arm: bytes in, bytes out, and a servo of its own that renders force fields.
// It runs in the time that its owner gives it.

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <string>

#include "drivers/twins/held_arm.h"
#include "drivers/vrpn_messages.h"

namespace prosector {

struct VrpnTwinOptions : HeldArmOptions {
  std::string name = "Arm0";
  std::uint64_t seed = 1;
  double garbage = 0;  // share of reports whose numbers are random
};

class VrpnTwin {
 public:
  VrpnTwin(VrpnTwinOptions options, std::int64_t now_ns);

  /// Takes a client's bytes.
  void receive(std::span<const std::uint8_t> bytes);
  /// Goes on to that time, and reports to a client that has greeted. Returns what is to be sent.
  vrpn::Bytes advance(std::int64_t now_ns);
  /// Lets the client go, and its force with it.
  void hang_up();
  /// Sends a code of Force_Error with the next report.
  void complain(std::int32_t code) { complaint_ = code; }
  /// Changes a button, of which the next report tells.
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
  std::optional<std::int32_t> complaint_;
  std::optional<bool> button_;
  std::uint64_t bad_messages_ = 0;
};

}  // namespace prosector
