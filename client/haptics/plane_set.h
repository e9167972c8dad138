#pragma once
// What a hand feels: all its contact planes, as the newest message has them.

#include <cstdint>
#include <span>
#include <vector>

#include "client/haptics/plane_contact.h"
#include "client/haptics/rhythm.h"

namespace prosector {

class PlaneSet {
 public:
  /// Takes a message's planes, which arrived at `time` (s, of the servo's clock).
  void take(std::span<const ContactPlane> planes, double time);
  /// Notes that the newest message came once more.
  void heard_again(double time) { signs_.note(time); }
  /// Returns the sum of forces, and goes on by dt s.
  PlaneForce advance(const Pose& hand, const Vec3& velocity, double dt);
  bool touches() const { return !contacts_.empty(); }

  /// Tells whether so much time passed since the last message that none is to be expected any more.
  bool stale(double time) const { return signs_.broken(time); }

 private:
  std::vector<PlaneContact> contacts_;
  Rhythm news_;   // of messages that told something newer
  Rhythm signs_;  // of all signs of life
};

}  // namespace prosector
