#pragma once
// Support of a body in trials where nothing ties it in its scene: a bed of springs in its lower part.

#include <optional>

#include "common/scene/scene.h"
#include "server/accuracy/static_body.h"

namespace prosector {

/// Support of a body that nothing ties in its scene: a bed of springs in the tissue's volume. It is stiff at
/// the body's lowest level and fades out over two fifths of its height. It is smooth, so that meshes of any
/// cell size are held alike.
struct Foot {
  Vec3 axis = Vec3::UnitY();  // unit: down
  double level = 0;           // m along `axis`, of the lowest point
  double depth = 0;           // m, over which the stiffness fades out
  double stiffness = 0;       // N/m⁴, at the lowest level
};

/// Returns whether an attachment in the body's description holds any node of the mesh.
bool tied(const SoftDesc& desc, const TetMesh& mesh);

/// Returns the foot (the bed of springs on which a body stands in trials) for a body with that mesh. Returns
/// nothing if an attachment of the description holds the body.
std::optional<Foot> foot_of(const SoftDesc& desc, const TetMesh& mesh, const Vec3& gravity);

/// Returns the stiffness (n, N/m) with which the foot, a bed of springs under the body, ties each node.
VecX ties_of(const Foot& foot, const StaticBody& body);

/// Returns the unit vector that points down: along gravity, or −y if gravity is zero.
Vec3 down(const Vec3& gravity);

/// Lowest and highest coordinate of a mesh's nodes along an axis, m.
struct EndsAlong {
  double low, high;
  double length() const { return high - low; }
};
EndsAlong extent(const TetMesh& mesh, const Vec3& axis);

}  // namespace prosector
