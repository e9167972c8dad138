#pragma once
// Completion of a cut after the stroke's line has left the body. Tissue that was dragged along, and elements
// that were inverted, may have passed the line without being cut. The few elements involved would still
// connect the two sides of a complete cut.

#include "server/physics/mechanics/cutting/edge_splitter.h"
#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector::cutting {

/// Returns a mark (plane of the cut at a node, in the rest shape) for a node that the swept surface missed.
/// The plane passes through the node, with the mean normal of its marked neighbours.
BladeStroke::Mark mark_between(const TetComplex& complex, const Marks& marks, NodeId node);

/// Returns the faces whose nodes all lie on the cut (`marks`) and that are the last connection between two
/// parts of the body. Fragments with a volume up to `least_fragment`, m³, do not count as parts. Slitting the
/// faces completes the cut.
SlitFaces faces_between_parts(const TetComplex& complex, const Marks& marks, double least_fragment);

}  // namespace prosector::cutting
