#pragma once
// Layout of an island's vector of unknowns: first the soft members' nodes, 3 each, then the rigid members'
// twists, 6 each.

#include <vector>

#include "common/assert.h"
#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/mechanics/coupled/joint.h"

namespace prosector {

struct IslandLayout {
  Eigen::Index size = 0;
  Eigen::Index rigid_begin = 0;
  std::vector<Eigen::Index> soft;  // first unknown, by soft member
  // Member indices by soft body and by slot; undefined for other bodies.
  std::vector<std::size_t> soft_members, rigid_members;

  /// Computes the layout of the island. Allocates only when there are more members than before.
  void begin(const Island& island);

  Eigen::Index rigid(std::size_t member) const { return rigid_begin + 6 * static_cast<Eigen::Index>(member); }
  /// Returns the index of the rigid member of a side that is on a rigid body.
  std::size_t rigid_member(const JointSide& side) const {
    PROSECTOR_ASSERT(side.rigid >= rigid_begin && side.rigid < size);
    return static_cast<std::size_t>((side.rigid - rigid_begin) / 6);
  }
  /// Returns the side, which is fixed or on a member, in terms of the island's unknowns.
  JointSide resolve(const ContactSide& side) const;
};

}  // namespace prosector
