#pragma once
// Pieces that a cut taken back joins again: the free ones go back to where they came off.

#include <optional>
#include <span>
#include <vector>

#include "common/math.h"
#include "server/physics/organs/node_transfer.h"

namespace prosector {

/// A piece before its cut is taken back.
struct ApartPiece {
  const PieceMesh* mesh = nullptr;
  std::size_t joins = 0;           // the same number: they are one now
  const VecX* place = nullptr;     // 3 numbers of each node at least, m
  const VecX* velocity = nullptr;  // 3 numbers of each node at least, m/s
  bool tied = false;               // to its place in the room: it stays
};

/// As a rigid body, so that its shape stays what it is.
struct WayBack {
  Pose motion;                   // of its places
  Vec3 velocity = Vec3::Zero();  // m/s, of every node after it: that of what it comes back to
};

/// Returns the way that each piece goes back; nothing: it stays. The complex is as it is after the cut was
/// taken back. Of those that are one now the tied ones stay; where none is, the one with most nodes. Each
/// other one goes by the rigid motion that brings the nodes that the cut had doubled nearest to their twins.
/// (Least squares; Kabsch, Acta Crystallogr. A 32, 1976.)
std::vector<std::optional<WayBack>> ways_back(const TetComplex& complex, std::span<const ApartPiece> pieces);

}  // namespace prosector
