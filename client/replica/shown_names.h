#pragma once
// Body names in one language.

#include <string>
#include <string_view>

#include "common/scene_messages.h"

namespace prosector {

/// Replaces each body's `name` in the scene by its name in the language, if it has one. The name that the
/// scene's author gave is stored in `names` with an empty language.
void show_names(SceneInfo& scene, std::string_view language);

/// Returns the body's name as the scene's author wrote it, also after show_names() has replaced it by a
/// translation.
const std::string& authors_name(const SceneBody& body);

/// Returns whether `name` is the body's name in any of the scene's languages, compared exactly.
bool is_called(const SceneBody& body, std::string_view name);

}  // namespace prosector
