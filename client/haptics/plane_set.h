#pragma once
// All contact planes of a hand, updated from the newest message.

#include <cstdint>
#include <span>
#include <vector>

#include "client/haptics/message_rate.h"
#include "client/haptics/plane_contact.h"

namespace prosector {

/// Sum of the forces of all contact planes on a hand, room frame, with their stiffness, energy and power.
struct FeltWrench {
  Wrench wrench;                  // about the given pivot
  Mat3 stiffness = Mat3::Zero();  // N/m: with respect to displacements
  double torsion = 0;             // N·m/rad: largest torsional stiffness about any axis
  double stored = 0;              // J, elastic energy of the planes
  double power = 0;               // W, power supplied by moving surfaces
};

class PlaneSet {
 public:
  /// Replaces the contact planes by those of a message that arrived at `time` (s, servo clock). Force jumps
  /// of changed, new and missing planes are spread over one interval between messages.
  void take(std::span<const ContactPlane> planes, double time);
  /// Records that the server repeated the newest message, with unchanged planes, at `time` (s, servo clock).
  /// This keeps the connection from counting as lost.
  void repeat_received(double time) { message_rate_.note(time); }
  /// Advances all contacts by `dt` s, and returns the sum of their forces and the torque about `pivot` (m,
  /// room frame) on a hand with this pose and motion.
  FeltWrench advance(const Pose& hand, const HandMotion& motion, const Vec3& pivot, double dt);
  bool touches() const { return !contacts_.empty(); }

  /// Returns whether at `time` (s, servo clock) the last message of contact planes is so old that the
  /// connection counts as lost.
  bool stale(double time) const { return message_rate_.broken(time); }

 private:
  std::vector<PlaneContact> contacts_;
  MessageRate update_rate_;   // arrival times of messages with new content
  MessageRate message_rate_;  // arrival times of all messages
};

}  // namespace prosector
