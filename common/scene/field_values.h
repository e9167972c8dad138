#pragma once
// The values of a scene as bytes, for hashes.

#include "common/byte_stream.h"
#include "common/scene/scene.h"

namespace prosector {

/// Adds the keys that are hashed by value (Hashed) and differ from their defaults, in the tables' order.
/// Scenes have equal bytes if and only if these keys have equal values.
void add_values(const SceneDesc& scene, ByteWriter& out);

}  // namespace prosector
