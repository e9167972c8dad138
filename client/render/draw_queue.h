#pragma once
// A DrawList's items with their GPU meshes, ready for the passes. Private to client/render.

#include <vector>

#include "client/render/mesh_cache.h"

namespace prosector {

struct QueuedItem {
  const DrawItem* item;
  MeshCache::Entry mesh;
  Sphere bounds;  // room frame
};

}  // namespace prosector
