#include "server/physics/mechanics/soft/springs/spring_parts.h"

namespace prosector::soft {

void add_springs(std::span<const Vec3> x, std::vector<StiffnessPart> parts, SpringNetwork& network) {
  sort_parts(x.size(), parts);
  network.springs.reserve(network.springs.size() + parts.size());
  for_each_place(parts, [&](auto first, auto last) {
    double k = 0;
    for (auto part = first; part != last; ++part) k += part->value;
    const double l = (x[first->at[0]] - x[first->at[1]]).norm();
    if (l > 0 && k > 0)
      network.springs.push_back({first->at, l, k});
    else
      ++network.dropped;
  });
}

}  // namespace prosector::soft
