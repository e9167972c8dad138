#pragma once
// What a hand feels: all its contact planes, as the newest message has them.

#include <cstdint>
#include <span>
#include <vector>

#include "client/haptics/plane_contact.h"

namespace prosector {

class PlaneSet {
 public:
  /// Takes a message's planes, which arrived at `time` (s, of the servo's clock), with the hand at `hand`.
  void take(std::span<const ContactPlane> planes, const Pose& hand, double time);
  /// Returns the sum of forces, and goes on by dt s.
  PlaneForce advance(const Pose& hand, const Vec3& velocity, double dt);
  bool touches() const { return !contacts_.empty(); }

  /// Tells whether so much time passed since the last message that none is to be expected any more.
  bool stale(double time) const;

 private:
  std::vector<PlaneContact> contacts_;
  double last_ = -1;           // s: when the newest message came; below 0: none did
  double interval_ = 1. / 60;  // s, between messages, of late …
  double jitter_ = 0;          // … and by how much that varies
};

}  // namespace prosector
