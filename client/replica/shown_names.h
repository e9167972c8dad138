#pragma once
// Body names in one language.

#include <string>
#include <string_view>

#include "common/scene_messages.h"

namespace prosector {

/// Replaces each body's name by its name in the language (name_in). The author's name is stored in `names`
/// with an empty language.
void show_names(SceneInfo& scene, std::string_view language);

/// Returns the body's name as written by the scene's author, independent of the language.
const std::string& authors_name(const SceneBody& body);

/// Reports whether the body has this name in any language.
bool is_called(const SceneBody& body, std::string_view name);

}  // namespace prosector
