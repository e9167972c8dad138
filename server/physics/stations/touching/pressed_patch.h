#pragma once
// Load of the last tick on the part of a soft surface that one part of a rigid body presses.

#include <cstdint>
#include <utility>
#include <vector>

#include "server/physics/mechanics/contact/contact.h"

namespace prosector {

/// Sum of the last tick's contact forces between a soft body and one part of a rigid body, and the nodes that
/// took them.
class PressedPatch {
 public:
  /// Adds a contact's normal force (N) of the last tick, on the side of the soft body.
  void add(const contact::ContactSide& side, double force);

  double force() const { return force_; }  // N
  /// Returns Σw² of the fractions w of the force that nodes took. 1 if there was no force.
  double spread() const;

 private:
  double force_ = 0;
  std::vector<std::pair<std::uint32_t, double>> loads_;  // node, N; nodes may repeat
};

}  // namespace prosector
