#pragma once
// Rejoining of pieces after their cut is undone: free pieces move back to where they were cut off.

#include <optional>
#include <span>
#include <vector>

#include "common/math.h"
#include "server/physics/mechanics/organs/node_transfer.h"

namespace prosector {

/// State of a piece before its cut is undone.
struct SeparatedPiece {
  const PieceMesh* mesh = nullptr;
  std::size_t joins = 0;           // group: pieces with the same number are one now
  const VecX* place = nullptr;     // 3 numbers of each node at least, m
  const VecX* velocity = nullptr;  // 3 numbers of each node at least, m/s
  bool tied = false;               // attached to the room: it stays
};

/// Rigid motion with which a piece moves back, so that it keeps its shape.
struct ReturnMotion {
  Pose motion;  // of its positions
  // m/s, of all nodes after the motion: velocity of the piece that it returns to.
  Vec3 velocity = Vec3::Zero();
};

/// Returns by piece the motion with which it moves back; none: it stays. The complex is in its state after
/// the undo. In each group the attached pieces stay or, without any, the piece with most nodes. Each other
/// piece moves by the rigid motion that brings its nodes nearest to their duplicates from the cut, by least
/// squares (Kabsch, Acta Crystallogr. A 32, 1976).
std::vector<std::optional<ReturnMotion>> ways_back(const TetComplex& complex,
                                                   std::span<const SeparatedPiece> pieces);

}  // namespace prosector
