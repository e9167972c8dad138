#pragma once
// Behaviour of models under strong compression.

#include <string>

#include "common/scene/scene.h"

namespace prosector::soft {

/// Returns a sentence for the scene's author about how the described body fails under strong compression, for
/// example that it stays collapsed. Empty if the body's energy leads back to the rest shape from every shape
/// that was tried. `solid`: whether the body consists of tetrahedra; others have no such limit. Bodies with a
/// limit recover under another material law (coupled/recovery.h).
std::string limit_under_compression(const SoftDesc& desc, bool solid);

}  // namespace prosector::soft
