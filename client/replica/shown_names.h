#pragma once
// The names of bodies as a reader of one language sees them.

#include <string>
#include <string_view>

#include "common/messages.h"

namespace prosector {

/// Puts each body's name in the language of the tag (name_in) into its place. The author's name is kept among
/// `names`, without a language.
void show_names(SceneInfo& scene, std::string_view language);

/// Returns the body's name as the scene's author wrote it: the same for everyone.
const std::string& authors_name(const SceneBody& body);

/// Tells whether the body is called so, in any language.
bool is_called(const SceneBody& body, std::string_view name);

}  // namespace prosector
