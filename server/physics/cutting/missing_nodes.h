#pragma once
// What of a surface the blade should have swept it missed, as a minimum vertex cut.

#include <vector>

#include "server/physics/cutting/edge_splitter.h"
#include "server/physics/cutting/tet_complex.h"

namespace prosector {

/// Returns how many nodes may hold together what the blade went right through. Where more do, it didn't.
std::size_t most_missing(const TetComplex& complex, const Marks& marks);

/// Returns the fewest nodes that, with the marked ones, part the tissue above the marks from that below, all
/// of them beside marks. Returns none where that takes more than `most`. Nodes that no mark sees on a side
/// are preferred. They are a vertex cut of a unit network, found by all augmenting paths of one length at a
/// time (Dinic 1970; Even and Tarjan 1975).
std::vector<NodeId> missing_nodes(const TetComplex& complex, const Marks& marks, std::size_t most);

}  // namespace prosector
