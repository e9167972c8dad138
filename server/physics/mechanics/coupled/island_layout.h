#pragma once
// Layout of an island's vector of unknowns: first the soft members' nodes, 3 each, then the rigid members'
// twists, 6 each.

#include <vector>

#include "common/assert.h"
#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/mechanics/coupled/joint.h"

namespace prosector::coupled {

struct IslandLayout {
  Eigen::Index size = 0;
  Eigen::Index rigid_begin = 0;
  std::vector<Eigen::Index> soft;  // first unknown, by soft member
  // Member indices by soft body and by slot; undefined for other bodies.
  std::vector<std::size_t> soft_members, rigid_members;

  /// Assigns the island's soft bodies (3 unknowns per node), then its rigid bodies (6 each), to ranges of the
  /// vector of unknowns. Allocates memory only when there are more bodies than before.
  void begin(const Island& island);

  Eigen::Index rigid(std::size_t member) const { return rigid_begin + 6 * static_cast<Eigen::Index>(member); }
  /// Returns the index of the rigid body to which a side of a contact or tie belongs, among the island's
  /// rigid bodies. The side must be on a rigid body.
  std::size_t rigid_member(const JointSide& side) const {
    PROSECTOR_ASSERT(side.rigid >= rigid_begin && side.rigid < size);
    return static_cast<std::size_t>((side.rigid - rigid_begin) / 6);
  }
  /// Converts a side of a contact or tie, given by body and nodes, into indices in the island's vector of
  /// unknowns. The side must be fixed or on a body of this island. A fixed side has no unknowns.
  JointSide resolve(const contact::ContactSide& side) const;
};

}  // namespace prosector::coupled
