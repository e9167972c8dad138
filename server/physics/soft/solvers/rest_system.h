#pragma once
// A body at rest, as what preconditions its matrix is made from it.

#include <span>

#include "server/physics/soft/base/connectivity.h"
#include "server/physics/soft/matrices/block_matrix.h"

namespace prosector {

struct RestSystem {
  const BlockPattern& pattern;      // must outlive what is made of it, as `elements` must
  const Connectivity& elements;     // whose matrix it is
  std::span<const Mat3> stiffness;  // K's blocks, N/m
  const VecX& positions;            // 3n, m
  const VecX& mass;                 // n, kg
  const VecX& attached;             // n, N/m
};

}  // namespace prosector
