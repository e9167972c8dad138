#pragma once
// Builds the islands that are solved together.

#include <optional>
#include <span>
#include <vector>

#include "server/physics/mechanics/contact/soft_contacts.h"
#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/mechanics/organs/blade.h"
#include "server/physics/stations/hands/pads.h"
#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Finds the islands of the rigid world: sets of bodies connected by contacts, holds and blades in tissue.
/// `reached`: contacts that hands and held bodies make within the tick. The rigid world immediately solves
/// islands without tissue and hands for h s. Returns the other islands.
const std::vector<rigid::MixedIsland>& find_islands(Bodies& bodies, std::span<const hands::Hand> hands,
                                                    std::span<const rigid::RigidContact> reached,
                                                    const contact::SoftContacts& touching,
                                                    std::span<const organs::BladeGrip> grips, double h);

/// Builder of the islands (sets of connected bodies that are solved together) that contain tissue or hands,
/// from contacts and holds.
class IslandBuilder {
 public:
  /// Stores references to the inputs of a tick of h s: bodies, hands and the contacts that they make within
  /// the tick, contacts with tissue, colliders and ties of blades. They must outlive the builder.
  IslandBuilder(Bodies& bodies, std::span<const hands::Hand> hands,
                std::span<const rigid::RigidContact> reached, const contact::SoftContacts& touching,
                std::span<const contact::Collider> colliders, std::span<const organs::BladeGrip> grips,
                double h);

  /// Fills `islands`: first those of `mixed`, which contain rigid bodies, then islands of soft bodies only.
  /// Appends the contacts of finger pads to `pads`.
  void build(std::span<const rigid::MixedIsland> mixed, std::vector<coupled::Island>& islands,
             std::vector<Pad>& pads);

 private:
  void add_rigid_members(const rigid::MixedIsland& mixed, coupled::Island& island);
  void add_rigid_contacts(const rigid::MixedIsland& mixed, std::size_t index, coupled::Island& island,
                          std::vector<Pad>& pads) const;
  void find_islands_of_groups();
  void add_soft_members(std::vector<coupled::Island>& islands);
  void watch_flat_elements(coupled::Island& island) const;
  void set_stiffness(coupled::Island& island) const;
  void add_ties(std::vector<coupled::Island>& islands) const;

  Bodies& bodies_;
  std::span<const hands::Hand> hands_;
  std::span<const rigid::RigidContact> reached_;
  const contact::SoftContacts& touching_;
  std::span<const contact::Collider> colliders_;
  std::span<const organs::BladeGrip> grips_;
  double h_;
  std::vector<std::size_t> island_of_;                       // by slot
  std::vector<std::optional<std::size_t>> island_of_group_;  // by soft group
};

}  // namespace prosector
