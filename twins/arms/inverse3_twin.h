#pragma once
// A simulated Inverse3 behind its service: text messages in both directions, and arm mechanics. The owner
// advances its time.

#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include "drivers/protocols/inverse3_messages.h"
#include "twins/arms/held_arm.h"

namespace prosector {

struct Inverse3TwinOptions : HeldArmOptions {
  std::uint64_t seed = 1;
  double garbage = 0;  // fraction of texts that are corrupted or truncated
};

class Inverse3Twin {
 public:
  Inverse3Twin(Inverse3TwinOptions options, std::int64_t now_ns);

  /// Starts the session of a client of the simulated service. Returns the first state message to send to it.
  std::string begin();
  /// Processes a client's text, a force command in JSON. A text without a valid force sets a force of zero.
  void take(std::string_view text);
  /// Ends the client's session: the motors are switched off and the simulated hand releases the arm.
  void end() { arm_.put_down(); }
  void advance(std::int64_t now_ns);
  /// Returns the state message with which the simulated service answers a client's text.
  std::string state() { return text(false); }
  void go_on(std::int64_t now_ns) { arm_.go_on(now_ns); }

  const HeldArm& arm() const { return arm_; }
  std::uint64_t bad_texts() const { return bad_texts_; }

  bool unplugged = false;  // the service has no arm
  std::uint32_t buttons = 0;
  double garbage;

 private:
  std::string text(bool first);

  HeldArm arm_;
  std::mt19937_64 random_;
  std::int64_t now_ns_;
  std::uint64_t bad_texts_ = 0;
};

}  // namespace prosector
