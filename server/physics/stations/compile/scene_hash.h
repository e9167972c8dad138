#pragma once
// Hash that identifies a compiled scene in checkpoints, recordings and caches.

#include <span>

#include "server/physics/world/model.h"

namespace prosector {

/// Returns a hash of everything that affects the result of a tick, or the drawn shapes. It includes the
/// scene's hashed values (common/scene/field_values.h), and the bodies' compiled shapes, masses, poses and
/// attachments.
ContentHash hash_of(const Model& model, std::span<const CompiledTissue> soft);

}  // namespace prosector
