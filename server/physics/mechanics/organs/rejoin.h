#pragma once
// Rejoining of pieces after their cut is undone: free pieces move back to where they were cut off.

#include <optional>
#include <span>
#include <vector>

#include "common/math.h"
#include "server/physics/mechanics/organs/node_transfer.h"

namespace prosector::organs {

/// State of a severed piece of an organ before the cut is undone: its mesh, node positions and velocities.
/// Also the group of pieces that the undo joins, and whether the piece is attached to the room.
struct SeparatedPiece {
  const PieceMesh* mesh = nullptr;
  std::size_t joins = 0;           // group: pieces with the same number are one now
  const VecX* place = nullptr;     // 3 numbers of each node at least, m
  const VecX* velocity = nullptr;  // 3 numbers of each node at least, m/s
  bool tied = false;               // attached to the room: it stays
};

/// Rigid motion that moves a severed piece back to the place where it was cut off, and the velocity (m/s)
/// that all its nodes get then.
struct ReturnMotion {
  Pose motion;  // of its positions
  // m/s, of all nodes after the motion: velocity of the piece that it returns to.
  Vec3 velocity = Vec3::Zero();
};

/// Returns for each piece the rigid motion that moves it back to where it was cut off, when that cut is
/// undone. `complex`: the organ's mesh after the undo. None means that the piece stays. In each group of
/// joined pieces the attached ones stay; without any, the piece with the most nodes stays. Each other piece
/// moves so that its nodes come nearest, in least squares, to their duplicates across the cut (Kabsch, Acta
/// Crystallogr. A 32, 1976).
std::vector<std::optional<ReturnMotion>> ways_back(const cutting::TetComplex& complex,
                                                   std::span<const SeparatedPiece> pieces);

}  // namespace prosector::organs
