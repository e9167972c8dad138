#pragma once
// Contacts of an island that its bodies' displacements in the tick can close.
//
// Contacts are found up to a distance that no motion of the tick exceeds, so most of them stay open. An open
// contact has no energy, force or stiffness, so leaving it out changes no result.

#include <cstdint>
#include <vector>

#include "server/physics/mechanics/coupled/island_layout.h"

namespace prosector::coupled {

/// List of an island's contacts that may act. It grows as the unknowns move away from the tick's start.
class ContactReach {
 public:
  /// Starts a tick of `island` with those contacts that act without any displacement, and all contacts that
  /// are not between tissue and something else. `start`: m, positions of the soft nodes, from which
  /// displacements are measured. Stores pointers to `layout` and `start`.
  void begin(const Island& island, const IslandLayout& layout, const VecX& start);
  /// Extends the list so that it has all contacts that may act at the unknowns q. Returns whether it changed.
  bool cover(const VecX& q);
  /// Returns the indices of the listed contacts in Island::contacts, ascending.
  const std::vector<std::uint32_t>& listed() const { return listed_; }

 private:
  /// Bound of a rigid body's displacement since the tick's start: of its centre of mass (m), and its rotation
  /// (rad).
  struct Twist {
    double way = 0, turn = 0;
  };
  /// Contribution of one side to a contact's displacement.
  struct Side {
    static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
    std::uint32_t first = 0, end = 0;  // soft: range in nodes_
    double weight = 0;                 // soft: sum of the nodes' absolute weights
    std::uint32_t rigid = none;        // rigid: index of the member
    double arm = 0;                    // m, rigid
  };
  struct Opening {
    double gap = 0;  // m, that displacements must exceed; < 0: listed from the start
    Side a, b;
  };

  Side side_of(const contact::ContactSide& side);
  Opening opening_of(const contact::Contact& c);
  double most_closing(const Side& side) const;
  bool may_act(const Opening& opening) const;
  bool extend_nodes(const VecX& q);
  bool extend_rigid(const VecX& q);
  void list();

  const IslandLayout* layout_ = nullptr;
  const VecX* start_ = nullptr;
  std::vector<Opening> openings_;     // by contact
  std::vector<std::uint32_t> nodes_;  // of all sides
  // Displacements that the list covers: of nodes (m, by first unknown / 3), and of rigid bodies.
  std::vector<double> ways_;
  std::vector<Twist> twists_;
  std::vector<std::uint32_t> listed_;
};

}  // namespace prosector::coupled
