#include "server/physics/mechanics/coupled/island_layout.h"

#include "common/assert.h"

namespace prosector::coupled {
namespace {

void set(std::vector<std::size_t>& members, std::size_t body, std::size_t member) {
  if (members.size() <= body) members.resize(body + 1);
  members[body] = member;
}

}  // namespace

void IslandLayout::begin(const Island& island) {
  size = 0;
  soft.clear();
  for (const SoftMember& m : island.soft) {
    soft.push_back(size);
    size += 3 * m.body->nodes();
  }
  rigid_begin = size;
  size += 6 * static_cast<Eigen::Index>(island.rigid.size());
  for (std::size_t m = 0; m < island.soft.size(); ++m) set(soft_members, island.soft[m].index, m);
  for (std::size_t m = 0; m < island.rigid.size(); ++m) set(rigid_members, island.rigid[m].slot, m);
}

JointSide IslandLayout::resolve(const contact::ContactSide& side) const {
  PROSECTOR_ASSERT(side.nodes <= contact::ContactSide::most_nodes);
  JointSide out;
  if (side.kind == contact::ContactSide::Kind::soft) {
    const std::size_t m = soft_members[side.body];
    PROSECTOR_ASSERT(m < soft.size());
    out.member = m;
    out.nodes = side.nodes;
    out.weight = side.weight;
    for (std::size_t k = 0; k < side.nodes; ++k)
      out.offset[k] = soft[m] + 3 * static_cast<Eigen::Index>(side.node[k]);
  } else if (side.kind == contact::ContactSide::Kind::rigid) {
    PROSECTOR_ASSERT(side.body < rigid_members.size() && rigid(rigid_members[side.body]) < size);
    out.rigid = rigid(rigid_members[side.body]);
    out.arm = side.arm;
  }
  return out;
}

}  // namespace prosector::coupled
