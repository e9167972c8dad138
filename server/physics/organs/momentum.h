#pragma once
// Momentum of a sheet through a cut.

#include <span>

#include "server/physics/organs/node_transfer.h"

namespace prosector {

struct PieceMotion {
  const PieceMesh* mesh;
  const VecX* mass;  // n, kg
  VecX* velocity;    // 3n, m/s
};

/// A sheet's new nodes take of the mass of their neighbours without regard to where the centre of mass is, so
/// what they carry over of velocities isn't their neighbours' momentum. Adds to the nodes that a change made
/// or gave another mass the one velocity that keeps the momentum of all. Spin about the centre of mass is
/// what comes of that.
void keep_momentum(std::span<const PieceMotion> before, std::span<const PieceMotion> now);

}  // namespace prosector
