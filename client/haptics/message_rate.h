#pragma once
// Mean interval and jitter of arriving messages.

namespace prosector {

class MessageRate {
 public:
  /// Records a message that arrived at `time`, s, and updates mean interval and jitter.
  void note(double time);
  /// Returns whether at `time`, s, the stream of messages counts as interrupted. It does after three times
  /// the mean interval plus jitter, at least 20 ms and at most 250 ms, without a message.
  bool broken(double time) const;
  double interval() const { return interval_; }  // s, mean interval between messages

 private:
  double last_ = -1;           // s: arrival of the newest message; negative: none yet
  double interval_ = 1. / 60;  // s
  double jitter_ = 0;          // s: mean deviation of the intervals
};

}  // namespace prosector
