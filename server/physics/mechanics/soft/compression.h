#pragma once
// Behaviour of models under strong compression.

#include <string>

#include "common/scene/scene.h"

namespace prosector {

/// Returns the limit of the described body under strong compression, as a sentence for the scene's author.
/// Empty if the body's energy leads back to the rest shape from every shape that was tried. Bodies with a
/// limit recover under another law (coupled/recovery.h), with another accuracy.
std::string limit_under_compression(const SoftDesc& desc, bool solid);

}  // namespace prosector
