#pragma once
// What is done when a stroke's line has left the body: tissue that was drawn along, and elements that it
// turned over, may have passed the line unseen, and what little they hold keeps whole what the blade went
// right through.

#include <vector>

#include "server/physics/cutting/edge_splitter.h"
#include "server/physics/cutting/tet_complex.h"

namespace prosector {

/// The fewest nodes that, with the marked ones, part the tissue above the marks from that below; none where
/// that takes more than `most`; those that no mark sees on a side are preferred. Vertex cut of a unit
/// network, by augmenting paths (Ford and Fulkerson 1956; Even 1975).
std::vector<NodeId> missing_nodes(const TetComplex& complex, const Marks& marks, std::size_t most);

/// A mark for such a node: the mean of its marked neighbours' planes, through it.
BladeStroke::Mark mark_between(const TetComplex& complex, const Marks& marks, NodeId node);

/// The faces of three marked nodes that are all that still joins parts of the body larger than a crumb.
SlitFaces faces_between_parts(const TetComplex& complex, const Marks& marks, double crumb);

}  // namespace prosector
