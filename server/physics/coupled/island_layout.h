#pragma once
// Where an island's degrees of freedom lie in its vector of unknowns: first the soft members' nodes, 3 each,
// then the rigid members' twists, 6 each.

#include <vector>

#include "server/physics/coupled/joint.h"
#include "server/physics/island.h"

namespace prosector {

struct IslandLayout {
  Eigen::Index size = 0;
  Eigen::Index rigid_begin = 0;
  std::vector<Eigen::Index> soft;                        // by soft member
  std::vector<std::size_t> soft_members, rigid_members;  // of bodies by index, by slot; of others anything

  /// Lays out the island's members. Allocates only for more than there ever were.
  void begin(const Island& island);

  Eigen::Index rigid(std::size_t member) const { return rigid_begin + 6 * static_cast<Eigen::Index>(member); }
  /// Returns which rigid member a side is on, which is on one.
  std::size_t rigid_member(const JointSide& side) const {
    return static_cast<std::size_t>((side.rigid - rigid_begin) / 6);
  }
  /// Returns the side, which is on a member or fixed, as unknowns of the island.
  JointSide resolve(const ContactSide& side) const;
};

}  // namespace prosector
