#pragma once
// What is done when a stroke's line has left the body. Tissue that was drawn along, and elements that it
// turned over, may have passed the line unseen. What little they hold keeps whole what the blade went right
// through.

#include "server/physics/cutting/edge_splitter.h"
#include "server/physics/cutting/tet_complex.h"

namespace prosector {

/// Returns a mark for a node that was missed: the mean of its marked neighbours' planes, through it.
BladeStroke::Mark mark_between(const TetComplex& complex, const Marks& marks, NodeId node);

/// Returns the faces of three marked nodes that are all that still joins parts of the body larger than a
/// crumb.
SlitFaces faces_between_parts(const TetComplex& complex, const Marks& marks, double crumb);

}  // namespace prosector
