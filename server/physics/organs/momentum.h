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

/// A sheet's new nodes take of the mass of their neighbours without regard to where the centre of mass is, so
/// what they carry over of velocities isn't their neighbours' momentum. Adds to the nodes that a change made
/// or gave another mass the one velocity that keeps the momentum of all and, if `spin`, the one turn about
/// their own centre of mass that keeps the angular momentum of all about its centre of mass: to rounding, but
/// about an axis that they lie on.
void keep_momentum(std::span<const PieceMotion> before, std::span<const PieceMotion> now, bool spin);

}  // namespace prosector
