#pragma once
// Doubt about poses that leap: a torn picture turns a hand over now and then, and no hand is that fast.

#include <cstdint>
#include <optional>

#include "common/math.h"

namespace prosector {

/// Follows one hand's poses. One that leaps is believed once two more pictures show it.
class PoseDoubt {
 public:
  /// Takes the next pose, of the palm's middle, and tells whether it is to be believed.
  bool believes(const Pose& palm, std::int64_t time_ns);
  /// Forgets the hand: its next pose is believed.
  void forget() { believed_.reset(); }

 private:
  struct Seen {
    Pose palm;
    std::int64_t time_ns = 0;
  };
  static bool leaps(const Seen& from, const Seen& to);

  std::optional<Seen> believed_, leapt_;
  int seen_again_ = 0;  // the leap, after its first picture
};

}  // namespace prosector
