#pragma once
// What people expect of organs a while after the hands have left them: that they have their volume, are the
// right way out, and are apart.

#include <map>
#include <string>
#include <utility>

#include "server/physics/simulation.h"

namespace prosector::test {

/// What is allowed 5 s after the last hand has left.
struct Bounds {
  double least_volume = 0.7, most_volume = 1.3;  // of the rest volume
  double most_overlap = 2e-3;                    // m, beyond what the scene itself puts into each other
};

/// The worst that was found.
struct Finding {
  double least_volume = 1, most_volume = 1;  // of the rest volume, over solid tissue
  double overlap = 0;                        // m, beyond the scene's own, over pairs that may touch
  double inverted = 0;                       // share of a body's volume
  std::string where;                         // the first body or pair out of bounds; empty: none
  bool good() const { return where.empty(); }
};

/// Remembers how deep the scene puts its organs into each other.
class Judge {
 public:
  explicit Judge(const Simulation& simulation);
  Finding look(const Simulation& simulation, const Bounds& bounds = {}) const;

 private:
  std::map<std::pair<BodyId, BodyId>, double> at_start_;  // m
};

/// Volume of a solid soft body now over that at rest; mirrored elements count negative.
double volume_ratio(const Simulation& simulation, BodyId soft_body);

/// Depth of the deepest surface vertex of either body in the other, m.
double overlap(const Simulation& simulation, BodyId a, BodyId b);

}  // namespace prosector::test
