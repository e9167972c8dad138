#pragma once
// Momentum of a sheet through a cut.

#include <span>

#include "server/physics/cutting/tet_complex.h"

namespace prosector {

struct PieceMotion {
  std::span<const NodeId> nodes;  // n
  const VecX* mass;               // n, kg
  const VecX* place;              // 3n, m
  VecX* velocity;                 // 3n, m/s
};

/// Adds to the nodes that a change made or gave another mass the one velocity that keeps the momentum of all.
/// If `spin`, it also adds the one turn about their own centre of mass that keeps the angular momentum of all
/// about its centre of mass. Both are kept to rounding, but for a turn about an axis that the nodes lie on. A
/// sheet's new nodes take of the mass of their neighbours without regard to where the centre of mass is. So
/// what they carry over of velocities isn't their neighbours' momentum.
void keep_momentum(std::span<const PieceMotion> before, std::span<const PieceMotion> now, bool spin);

}  // namespace prosector
