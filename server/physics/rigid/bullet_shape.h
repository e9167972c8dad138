#pragma once
// Our shapes as Bullet's. Only for the .cpp files of this folder.

#include <memory>

#include "server/physics/collision/shapes/shape.h"
#include "server/physics/rigid/bullet_types.h"

namespace prosector {

/// A body's shape and all that it refers to.
struct BulletShape {
  std::vector<std::unique_ptr<btTriangleMesh>> meshes;
  std::vector<std::unique_ptr<btCollisionShape>> parts;
  std::unique_ptr<btCompoundShape> compound;  // empty when one centred part is the whole shape
  btCollisionShape* root = nullptr;           // null: collides with nothing
};

/// Makes a body's shape. `dynamic` bodies need a moving triangle mesh, fixed ones take the cheaper static
/// tree.
BulletShape make_bullet_shape(const std::vector<ShapePart>& parts, bool dynamic);

}  // namespace prosector
