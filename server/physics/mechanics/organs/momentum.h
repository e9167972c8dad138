#pragma once
// Conservation of momentum when a sheet is cut.

#include <span>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector::organs {

/// Nodes of one piece of a cut sheet, with their ids, masses (kg), positions (m) and velocities (m/s). The
/// velocities may be corrected in place.
struct PieceMotion {
  std::span<const cutting::NodeId> nodes;  // ids of its n nodes
  const VecX* mass;                        // n, kg: nodal masses
  const VecX* place;                       // 3n, m: node positions
  VecX* velocity;                          // 3n, m/s: node velocities
};

/// Corrects node velocities in `now` so that a cut of a sheet conserves total momentum. `before` and `now`:
/// all pieces before and after the change of the mesh. Adds one common velocity to all nodes that are new or
/// changed their mass. If `spin`, also adds one rotation about these nodes' centre of mass, which conserves
/// the total angular momentum. Both are conserved to rounding, except for rotation about an axis on which all
/// these nodes lie. The correction is needed because new nodes take mass from their neighbours without
/// preserving the centre of mass.
void keep_momentum(std::span<const PieceMotion> before, std::span<const PieceMotion> now, bool spin);

}  // namespace prosector::organs
