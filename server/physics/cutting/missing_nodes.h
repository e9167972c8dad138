#pragma once
// What of a surface the blade should have swept it missed, as a minimum vertex cut.

#include <vector>

#include "server/physics/cutting/edge_splitter.h"
#include "server/physics/cutting/tet_complex.h"

namespace prosector {

/// So many nodes may hold together what the blade went right through. More, and it didn't.
std::size_t most_missing(const TetComplex& complex, const Marks& marks);

/// The fewest nodes that, with the marked ones, part the tissue above the marks from that below, all of them
/// beside marks; none where that takes more than `most`. Those that no mark sees on a side are preferred.
/// Vertex cut of a unit network, by all augmenting paths of one length at a time (Dinic 1970; Even and Tarjan
/// 1975).
std::vector<NodeId> missing_nodes(const TetComplex& complex, const Marks& marks, std::size_t most);

}  // namespace prosector
