#include "server/physics/stations/touching/pressed_patch.h"

#include <algorithm>

namespace prosector {

void PressedPatch::add(const contact::ContactSide& side, double force) {
  force_ += force;
  for (std::size_t k = 0; k < side.nodes; ++k) loads_.emplace_back(side.node[k], force * side.weight[k]);
}

double PressedPatch::spread() const {
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

}  // namespace prosector
