#pragma once
// A DrawList's items with their GPU meshes, as input of the passes. Private to client/render.

#include <vector>

#include "client/render/mesh_cache.h"

namespace prosector {

struct QueuedItem {
  const DrawItem* item;
  const MeshCache::Entry* mesh;  // valid until the next frame
  Sphere bounds;                 // world frame
};

inline void draw(const MeshCache& meshes, const QueuedItem& queued) {
  meshes.draw(*queued.mesh, queued.item->level);
}

}  // namespace prosector
