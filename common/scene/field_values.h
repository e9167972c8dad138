#pragma once
// Serialisation of a scene's values for hashing.

#include "common/byte_stream.h"
#include "common/scene/scene.h"

namespace prosector {

/// Appends those keys and values of the scene to `out` that are hashed by value (Hashed::by_value) and differ
/// from their defaults, in table order. Two scenes give equal bytes if and only if these keys have equal
/// values.
void add_values(const SceneDesc& scene, ByteWriter& out);

}  // namespace prosector
