#pragma once
// Completion of a cut after the stroke's line has left the body. Tissue that was dragged along, and elements
// that were inverted, may have passed the line without being cut. The few elements involved would still
// connect the two sides of a complete cut.

#include "server/physics/mechanics/cutting/edge_splitter.h"
#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector {

/// Returns a mark for a node that the sweeps missed: a plane through the node, with the mean normal of its
/// marked neighbours.
BladeStroke::Mark mark_between(const TetComplex& complex, const Marks& marks, NodeId node);

/// Returns the faces with three marked nodes that are the last connection between parts of the body. Each
/// part has a volume above `crumb`, m³.
SlitFaces faces_between_parts(const TetComplex& complex, const Marks& marks, double least_fragment);

}  // namespace prosector
