#pragma once
// A simulated Inverse3 behind its service: texts in, texts out, mechanics behind them. It runs in the time
// that its owner gives it.

#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include "drivers/inverse3_messages.h"
#include "drivers/twins/held_arm.h"

namespace prosector {

struct Inverse3TwinOptions : HeldArmOptions {
  std::uint64_t seed = 1;
  double garbage = 0;  // share of texts that are random bytes, or broken off
};

class Inverse3Twin {
 public:
  Inverse3Twin(Inverse3TwinOptions options, std::int64_t now_ns);

  /// Lets a client begin. Returns the first state.
  std::string begin();
  /// Takes a client's text; what sets no force sets none.
  void take(std::string_view text);
  /// Lets the client go: its force ends with it.
  void end() { arm_.put_down(); }
  void advance(std::int64_t now_ns);
  /// Returns the state that answers a text.
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
