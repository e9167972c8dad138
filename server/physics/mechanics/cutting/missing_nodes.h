#pragma once
// Nodes that the swept surface should have cut but missed, found as a minimum vertex cut.

#include <vector>

#include "server/physics/mechanics/cutting/edge_splitter.h"
#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector::cutting {

/// Returns the largest number of nodes that the swept surface may have missed in a complete cut: 5 % of the
/// marked nodes, and at least 4 (1 for a sheet). If more nodes connect the two sides of the cut, the blade
/// did not pass completely through.
std::size_t most_missing(const TetComplex& complex, const Marks& marks);

/// Returns the fewest nodes that, together with the nodes marked as lying on the cut, separate the tissue
/// above the cut from the tissue below. Returns none if more than `most` are needed. All returned nodes are
/// adjacent to marked nodes. Nodes that are not clearly on one side of the cut are preferred. The nodes are a
/// minimum vertex cut of a unit-capacity network (Dinic 1970; Even and Tarjan 1975).
std::vector<NodeId> missing_nodes(const TetComplex& complex, const Marks& marks, std::size_t most);

}  // namespace prosector::cutting
