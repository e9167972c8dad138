#pragma once
// Support of a body in trials where nothing ties it in its scene: a bed of springs in its lower part.

#include <optional>

#include "common/scene/scene.h"
#include "server/accuracy/static_body.h"

namespace prosector {

/// A bed of springs in the tissue's volume. It is stiff at the body's lowest level and fades out over two
/// fifths of its height. It is smooth, so that meshes of any cell size are held alike.
struct Foot {
  Vec3 axis = Vec3::UnitY();  // unit: down
  double level = 0;           // m along `axis`, of the lowest point
  double depth = 0;           // m, over which the stiffness fades out
  double stiffness = 0;       // N/m⁴, at the lowest level
};

/// Returns whether a tie of the description holds a node of the mesh.
bool tied(const SoftDesc& desc, const TetMesh& mesh);

/// Returns the foot of a body with that mesh; nothing where a tie holds the body.
std::optional<Foot> foot_of(const SoftDesc& desc, const TetMesh& mesh, const Vec3& gravity);

/// Returns the foot's stiffness at each node, n, N/m.
VecX ties_of(const Foot& foot, const StaticBody& body);

/// Returns the unit vector downwards: along gravity, or −y where there is none.
Vec3 down(const Vec3& gravity);

/// Positions of a mesh's ends along an axis, m.
struct EndsAlong {
  double low, high;
  double length() const { return high - low; }
};
EndsAlong extent(const TetMesh& mesh, const Vec3& axis);

}  // namespace prosector
