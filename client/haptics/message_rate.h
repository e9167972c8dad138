#pragma once
// Mean interval and jitter of arriving messages.

namespace prosector {

class MessageRate {
 public:
  /// Records a message that arrived at `time`, s.
  void note(double time);
  /// Reports whether at `time`, s, the last message is so old that the stream counts as interrupted.
  bool broken(double time) const;
  double interval() const { return interval_; }  // s, mean interval between messages

 private:
  double last_ = -1;           // s: arrival of the newest message; negative: none yet
  double interval_ = 1. / 60;  // s
  double jitter_ = 0;          // s: mean deviation of the intervals
};

}  // namespace prosector
