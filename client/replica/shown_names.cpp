#include "client/replica/shown_names.h"

#include <algorithm>

namespace prosector {

void show_names(SceneInfo& scene, std::string_view language) {
  for (SceneBody& body : scene.bodies) {
    const std::string shown = name_in(language, body.name, body.names);
    body.names.push_back({"", body.name});
    body.name = shown;
  }
}

const std::string& authors_name(const SceneBody& body) {
  const auto found = std::ranges::find(body.names, std::string_view(), &LocalName::language);
  return found == body.names.end() ? body.name : found->name;
}

bool is_called(const SceneBody& body, std::string_view name) {
  return body.name == name || std::ranges::find(body.names, name, &LocalName::name) != body.names.end();
}

}  // namespace prosector
