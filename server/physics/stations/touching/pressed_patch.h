#pragma once
// Load of the last tick on the part of a soft surface that one part of a rigid body presses.

#include <algorithm>
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
  void add(const contact::ContactSide& side, double force) {
    force_ += force;
    for (std::size_t k = 0; k < side.nodes; ++k) loads_.emplace_back(side.node[k], force * side.weight[k]);
  }

  double force() const { return force_; }  // N
  /// Returns Σw² of the fractions w of the force that nodes took. 1 if there was no force.
  double spread() const {
    if (!(force_ > 0)) return 1;
    std::vector<std::pair<std::uint32_t, double>> sorted = loads_;
    std::sort(sorted.begin(), sorted.end());
    double sum = 0;
    for (std::size_t i = 0; i < sorted.size();) {
      double load = 0;
      for (const std::uint32_t node = sorted[i].first; i < sorted.size() && sorted[i].first == node; ++i)
        load += sorted[i].second;
      sum += load * load;
    }
    return std::min(sum / (force_ * force_), 1.0);
  }

 private:
  double force_ = 0;
  std::vector<std::pair<std::uint32_t, double>> loads_;  // node, N; nodes may repeat
};

}  // namespace prosector
