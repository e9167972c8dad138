#pragma once
// What models make of being squeezed.

#include <string>

#include "common/scene/scene.h"

namespace prosector {

/// Returns what a body so described does not survive when it is pressed hard, in a sentence for its author.
/// It is empty where the body's energy leads back from every shape that was tried. Such bodies recover under
/// another law (coupled/recovery.h), which is another accuracy.
std::string limit_under_compression(const SoftDesc& desc, bool solid);

}  // namespace prosector
