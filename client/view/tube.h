#pragma once
// Render mesh of a rope: a tube around its axis, with round ends.

#include <memory>
#include <span>

#include "client/view/draw_list.h"

namespace prosector {

/// Creates the render mesh of a rope: a tube of `diameter` metres around the polyline `axis` (at least two
/// points; coincident ones are skipped), with round ends.
std::shared_ptr<DrawMesh> tube_mesh(std::span<const Eigen::Vector3f> axis, float diameter,
                                    std::uint64_t mesh_id);

/// Moves a mesh that tube_mesh() created to a new `axis` with the same number of points. Its rings don't
/// twist against each other: each is the previous one rotated by the least rotation between their tangents.
/// See Bishop, There is more than one way to frame a curve, Amer. Math. Monthly 82, 1975. Allocates nothing.
void sweep_tube(std::span<const Eigen::Vector3f> axis, float diameter, DrawMesh& tube);

}  // namespace prosector
