#pragma once
// Conservation of momentum when a sheet is cut.

#include <span>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector {

/// Nodes of a piece with their masses, positions and velocities.
struct PieceMotion {
  std::span<const NodeId> nodes;  // ids of its n nodes
  const VecX* mass;               // n, kg: nodal masses
  const VecX* place;              // 3n, m: node positions
  VecX* velocity;                 // 3n, m/s: node velocities
};

/// Corrects velocities so that a change of the mesh conserves total momentum. Adds one common velocity to the
/// nodes that are new or changed their mass. If `spin`, also adds one rotation about their centre of mass,
/// which conserves the total angular momentum. Both hold to rounding, except for rotation about an axis on
/// which the nodes lie. A sheet's new nodes take mass from their neighbours without preserving the centre of
/// mass, so interpolated velocities alone don't conserve momentum.
void keep_momentum(std::span<const PieceMotion> before, std::span<const PieceMotion> now, bool spin);

}  // namespace prosector
