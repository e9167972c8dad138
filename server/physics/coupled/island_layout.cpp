#include "server/physics/coupled/island_layout.h"

namespace prosector {

void IslandLayout::begin(const Island& island) {
  size = 0;
  soft.clear();
  for (const SoftMember& m : island.soft) {
    soft.push_back(size);
    size += 3 * m.body->nodes();
  }
  rigid_begin = size;
  size += 6 * static_cast<Eigen::Index>(island.rigid.size());
}

JointSide IslandLayout::resolve(const Island& island, const ContactSide& side) const {
  JointSide out;
  if (side.kind == ContactSide::Kind::soft) {
    std::size_t m = 0;
    while (island.soft[m].index != side.body) ++m;
    out.member = m;
    out.nodes = side.nodes;
    out.weight = side.weight;
    for (std::size_t k = 0; k < side.nodes; ++k)
      out.offset[k] = soft[m] + 3 * static_cast<Eigen::Index>(side.node[k]);
  } else if (side.kind == ContactSide::Kind::rigid) {
    std::size_t m = 0;
    while (island.rigid[m].slot != side.body) ++m;
    out.rigid = rigid(m);
    out.arm = side.arm;
  }
  return out;
}

}  // namespace prosector
