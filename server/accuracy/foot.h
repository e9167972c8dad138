#pragma once
// What holds a body in trials where nothing ties it in its scene: a bed of springs in its lower part.

#include <optional>

#include "common/scene/scene.h"
#include "server/accuracy/static_body.h"

namespace prosector {

/// A bed of springs on the tissue's volume. It is firm at the body's lowest level and fades out over two
/// fifths of its height. It is smooth, so that meshes of any cell are held alike.
struct Foot {
  Vec3 axis = Vec3::UnitY();  // unit: down
  double level = 0;           // m along it, of the lowest point
  double depth = 0;           // m, over which it fades out
  double stiffness = 0;       // N/m⁴, at the lowest level
};

/// Tells whether any tie of the description holds a node of the mesh.
bool tied(const SoftDesc& desc, const TetMesh& mesh);

/// Returns the foot of a body of that mesh; nothing where something ties it.
std::optional<Foot> foot_of(const SoftDesc& desc, const TetMesh& mesh, const Vec3& gravity);

/// Returns the foot's stiffness at each node, n, N/m.
VecX ties_of(const Foot& foot, const StaticBody& body);

/// Returns where down is: along gravity, or −y where there is none.
Vec3 down(const Vec3& gravity);

/// Returns the mesh's ends along an axis, m.
struct EndsAlong {
  double low, high;
  double length() const { return high - low; }
};
EndsAlong extent(const TetMesh& mesh, const Vec3& axis);

}  // namespace prosector
