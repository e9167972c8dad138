#pragma once
// A rope as something to draw: a tube around its axis, with round ends.

#include <memory>
#include <span>

#include "client/view/draw_list.h"

namespace prosector {

/// Makes a tube of `diameter` metres around the line through `axis` (two points or more; those that coincide
/// are passed over).
std::shared_ptr<DrawMesh> tube_mesh(std::span<const Eigen::Vector3f> axis, float diameter,
                                    std::uint64_t mesh_id);

/// Lays a mesh of tube_mesh() around `axis`, as many points as it was made with. Its rings don't twist
/// against each other: each is the one before, turned by the least rotation between their tangents. See
/// Bishop, There is more than one way to frame a curve, Amer. Math. Monthly 82, 1975. Allocates nothing.
void sweep_tube(std::span<const Eigen::Vector3f> axis, float diameter, DrawMesh& tube);

}  // namespace prosector
