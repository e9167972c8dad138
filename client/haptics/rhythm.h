#pragma once
// How often messages come of late, and how unevenly.

namespace prosector {

class Rhythm {
 public:
  /// Notes a message that came at `time`, s.
  void note(double time);
  /// Tells whether so much time passed at `time` since the last message that none is to be expected any more.
  bool broken(double time) const;
  double interval() const { return interval_; }  // s, between messages

 private:
  double last_ = -1;           // s: when the newest message came; below 0: none did
  double interval_ = 1. / 60;  // s
  double jitter_ = 0;          // s: by how much intervals vary
};

}  // namespace prosector
