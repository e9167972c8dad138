#pragma once
// Islands made from contacts: what is solved together.

#include <optional>
#include <span>
#include <vector>

#include "server/physics/contact/colliders.h"
#include "server/physics/contact/soft_contacts.h"
#include "server/physics/hands/pads.h"
#include "server/physics/island.h"
#include "server/physics/organs/blade_grip.h"
#include "server/physics/state.h"

namespace prosector {

/// Finds what hangs together by contacts, holds and blades in tissue. The rigid world solves islands without
/// tissue and hands for h s at once; the others are returned.
const std::vector<MixedIsland>& find_islands(Bodies& bodies, std::span<const Hand> hands,
                                             const SoftContacts& touching, std::span<const BladeGrip> grips,
                                             double h);

class IslandBuilder {
 public:
  /// Sees all that the islands are made of for a tick of h s; all of it outlives this.
  IslandBuilder(Bodies& bodies, std::span<const Hand> hands, const SoftContacts& touching,
                std::span<const Collider> colliders, std::span<const BladeGrip> grips, double h);

  /// Fills `islands`: those of `mixed`, then those of soft bodies alone. Lists in `pads` which of their
  /// contacts are those of fingers.
  void build(std::span<const MixedIsland> mixed, std::vector<Island>& islands, std::vector<Pad>& pads);

 private:
  void add_rigid_members(const MixedIsland& mixed, Island& island);
  void add_rigid_contacts(const MixedIsland& mixed, std::size_t index, Island& island,
                          std::vector<Pad>& pads) const;
  void find_islands_of_groups();
  void add_soft_members(std::vector<Island>& islands);
  void watch_flat_elements(Island& island) const;
  void set_stiffness(Island& island) const;
  void add_ties(std::vector<Island>& islands) const;

  Bodies& bodies_;
  std::span<const Hand> hands_;
  const SoftContacts& touching_;
  std::span<const Collider> colliders_;
  std::span<const BladeGrip> grips_;
  double h_;
  std::vector<std::size_t> island_of_;                       // by slot
  std::vector<std::optional<std::size_t>> island_of_group_;  // by soft group
};

}  // namespace prosector
