#pragma once
// Nodes that the swept surface should have cut but missed, found as a minimum vertex cut.

#include <vector>

#include "server/physics/mechanics/cutting/edge_splitter.h"
#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector {

/// Returns the largest number of missed nodes that may still connect the two sides of a complete cut. If more
/// nodes connect them, the blade did not pass completely through.
std::size_t most_missing(const TetComplex& complex, const Marks& marks);

/// Returns the fewest nodes that, with the marked ones, separate the tissue above the marks from the tissue
/// below. All returned nodes are adjacent to marked nodes. Returns none if more than `most` are needed.
/// Prefers nodes that are not clearly on one side of the marks. The nodes are a minimum vertex cut of a
/// unit-capacity network (Dinic 1970; Even and Tarjan 1975).
std::vector<NodeId> missing_nodes(const TetComplex& complex, const Marks& marks, std::size_t most);

}  // namespace prosector
