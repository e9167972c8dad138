#pragma once
// Data of a body in its rest shape from which preconditioners are built.

#include <span>

#include "server/physics/mechanics/soft/base/connectivity.h"
#include "server/physics/mechanics/soft/matrices/block_matrix.h"

namespace prosector::soft {

struct RestSystem {
  const BlockPattern& pattern;      // must outlive preconditioners built from it, as `elements` must
  const Connectivity& elements;     // elements of the matrix
  std::span<const Mat3> stiffness;  // K's blocks, N/m
  const VecX& positions;            // 3n, m
  const VecX& mass;                 // n, kg
  const VecX& attached;             // n, N/m
};

}  // namespace prosector::soft
