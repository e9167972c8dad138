#pragma once
// Motion of the material around each node as one matrix: Σ (x_j − x_i)(X_j − X_i)ᵀ over the node i's
// neighbours j. Its polar factor is the best-fit rotation. In single precision.

#include <cstddef>

#include "server/physics/mechanics/soft/matrices/block_matrix.h"
#include "server/physics/mechanics/soft/simd/element_lanes.h"

namespace prosector::soft {

/// Computes for the nodes first … last − 1 the 3×3 matrices Σ (x_j − x_i)(X_j − X_i)ᵀ over the neighbours j
/// of node i, where x are current and X rest positions. Stores them in the lanes of F from 0 on; at most
/// elements_per_batch nodes. `x`, `rest`: four floats per node relative to an origin near the body; the
/// fourth is ignored.
void node_covariances(const BlockPattern& neighbours, const float* x, const float* rest, std::size_t first,
                      std::size_t last, LaneMatrix& F);

}  // namespace prosector::soft
