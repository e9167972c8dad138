#pragma once
// All contact planes of a hand, updated from the newest message.

#include <cstdint>
#include <span>
#include <vector>

#include "client/haptics/message_rate.h"
#include "client/haptics/plane_contact.h"

namespace prosector {

/// Sum of all planes' forces on a hand.
struct FeltWrench {
  Wrench wrench;                  // about the given pivot
  Mat3 stiffness = Mat3::Zero();  // N/m: with respect to displacements
  double torsion = 0;             // N·m/rad: largest torsional stiffness about any axis
  double stored = 0;              // J, elastic energy of the planes
  double power = 0;               // W, power supplied by moving surfaces
};

class PlaneSet {
 public:
  /// Replaces the planes by those of a message that arrived at `time` (s, servo clock).
  void take(std::span<const ContactPlane> planes, double time);
  /// Notes that the newest message was received again.
  void repeat_received(double time) { message_rate_.note(time); }
  /// Returns the sum of forces and their torque about `pivot` (m, room frame), and advances by dt s.
  FeltWrench advance(const Pose& hand, const HandMotion& motion, const Vec3& pivot, double dt);
  bool touches() const { return !contacts_.empty(); }

  /// Reports whether the last message is so old that the connection counts as lost.
  bool stale(double time) const { return message_rate_.broken(time); }

 private:
  std::vector<PlaneContact> contacts_;
  MessageRate update_rate_;   // arrival times of messages with new content
  MessageRate message_rate_;  // arrival times of all messages
};

}  // namespace prosector
