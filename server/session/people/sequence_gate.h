#pragma once
// Detects which samples of a stream are newer than those received before.

#include <cstdint>

namespace prosector {

/// Check of the sequence numbers of a stream whose samples may overtake each other. It rejects samples with a
/// number that is not above the highest one received. One damaged number that is far ahead must not silence
/// the stream. After `max_overtaken` rejected samples in a row, the numbering therefore restarts at the next
/// sample's number.
class SequenceGate {
 public:
  enum class Verdict : std::uint8_t { newer, overtaken, restarted };

  static constexpr std::uint32_t max_overtaken = 120;  // one second of hand inputs

  Verdict judge(std::uint64_t number) {
    const bool first = !any_, newer = number > last_;
    if (!first && !newer && ++behind_ < max_overtaken) return Verdict::overtaken;
    any_ = true;
    last_ = number;
    behind_ = 0;
    return first || newer ? Verdict::newer : Verdict::restarted;
  }

 private:
  bool any_ = false;
  std::uint64_t last_ = 0;
  std::uint32_t behind_ = 0;
};

}  // namespace prosector
