#pragma once
// Conversion of collision shapes to Bullet shapes. Only for the .cpp files of this folder.

#include <memory>

#include "server/physics/mechanics/collision/shapes/shape.h"
#include "server/physics/mechanics/rigid/bullet_types.h"

namespace prosector {

/// A body's Bullet shape and all objects that it refers to.
struct BulletShape {
  std::vector<std::unique_ptr<btTriangleMesh>> meshes;
  std::vector<std::unique_ptr<btCollisionShape>> parts;
  std::unique_ptr<btCompoundShape> compound;  // null if the shape is a single centred part
  btCollisionShape* root = nullptr;           // null: no collisions
};

/// Creates a body's shape. `dynamic` bodies need a moving triangle mesh; fixed bodies use the cheaper static
/// tree.
BulletShape make_bullet_shape(const std::vector<ShapePart>& parts, bool dynamic);

}  // namespace prosector
