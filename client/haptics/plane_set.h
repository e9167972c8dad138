#pragma once
// What a hand feels: all its contact planes, as the newest message has them.

#include <cstdint>
#include <span>
#include <vector>

#include "client/haptics/plane_contact.h"
#include "client/haptics/rhythm.h"

namespace prosector {

/// What all planes do to a hand together.
struct FeltWrench {
  Wrench wrench;                  // about the point that was asked for
  Mat3 stiffness = Mat3::Zero();  // N/m: by how much force falls along a way
  double torsion = 0;             // N·m/rad: by how much torque falls about a turn, at most
  double stored = 0;              // J, in the planes' springs
  double power = 0;               // W, that surfaces give by moving
};

class PlaneSet {
 public:
  /// Takes a message's planes, which arrived at `time` (s, of the servo's clock).
  void take(std::span<const ContactPlane> planes, double time);
  /// Notes that the newest message came once more.
  void heard_again(double time) { signs_.note(time); }
  /// Returns the sum of forces, and their torque about `pivot` (m, room), and goes on by dt s.
  FeltWrench advance(const Pose& hand, const HandMotion& motion, const Vec3& pivot, double dt);
  bool touches() const { return !contacts_.empty(); }

  /// Tells whether so much time passed since the last message that none is to be expected any more.
  bool stale(double time) const { return signs_.broken(time); }

 private:
  std::vector<PlaneContact> contacts_;
  Rhythm news_;   // of messages that told something newer
  Rhythm signs_;  // of all signs of life
};

}  // namespace prosector
