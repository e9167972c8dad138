#pragma once
// A simulated PHANTOM Omni in a modelled hand that follows a script: registers and packets, and arm
// mechanics. The owner advances its time.

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <span>

#include "twins/arms/held_arm.h"
#include "twins/arms/omni_body.h"

namespace prosector {

struct OmniTwinOptions : HeldArmOptions {
  std::uint64_t seed = 1;
  double garbage = 0;  // probability that a packet is random bytes
};

class OmniTwin {
 public:
  explicit OmniTwin(OmniTwinOptions options, std::int64_t now_ns);

  /// Returns the four bytes of the simulated Omni's register at an address, in bus order.
  std::array<std::uint8_t, 4> read(std::uint64_t address) const { return omni_body::register_bytes(address); }
  void write(std::uint64_t address, std::span<const std::uint8_t> bytes, std::int64_t now_ns);
  void command(std::span<const std::uint8_t> packet);
  /// Advances the simulated Omni to the time `now_ns`. Returns the state packet to send, or nothing if the
  /// host has not enabled packets.
  std::optional<std::array<std::uint8_t, omni_body::state_size>> advance(std::int64_t now_ns);
  void go_on(std::int64_t now_ns) { arm_.go_on(now_ns); }

  const HeldArm& arm() const { return arm_; }
  const ArmModel& model() const { return arm_.model(); }  // in the arm frame
  bool streaming() const { return streaming_; }
  std::uint64_t bad_commands() const { return bad_commands_; }

 private:
  std::array<std::uint8_t, omni_body::state_size> state() const;

  double garbage_;
  HeldArm arm_;
  std::mt19937_64 random_;
  std::int64_t started_ns_ = 0;
  bool streaming_ = false;
  std::optional<std::uint8_t> receives_on_, transmits_on_;  // isochronous channels
  omni_body::Encoders offset_{};                            // encoder counts in the inkwell, random at start
  std::uint32_t count_ = 0;
  std::uint64_t bad_commands_ = 0;
};

}  // namespace prosector
