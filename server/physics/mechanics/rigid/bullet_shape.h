#pragma once
// Conversion of collision shapes to Bullet shapes. Only for the .cpp files of this folder.

#include <memory>

#include "server/physics/mechanics/collision/shapes/shape.h"
#include "server/physics/mechanics/rigid/bullet_types.h"

namespace prosector::rigid {

/// Collision shape of a body for Bullet, with all objects that Bullet refers to by pointer.
struct BulletShape {
  std::vector<std::unique_ptr<btTriangleMesh>> meshes;
  std::vector<std::unique_ptr<btCollisionShape>> parts;
  std::unique_ptr<btCompoundShape> compound;  // null if the shape is a single centred part
  btCollisionShape* root = nullptr;           // null: no collisions
};

/// Creates a body's Bullet shape from its collision parts. Triangle parts of a `dynamic` body become a
/// triangle mesh that can move (GImpact). Those of a fixed body become Bullet's cheaper static triangle tree.
BulletShape make_bullet_shape(const std::vector<collision::ShapePart>& parts, bool dynamic);

}  // namespace prosector::rigid
