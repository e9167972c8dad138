#pragma once
// The shipped scenes, each with a preview image that the client renders once.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/render/image.h"
#include "client/setup/child_process.h"

namespace prosector {

struct ListedScene {
  std::filesystem::path file;
  std::string name, description;
  std::optional<Image> picture;
  std::string problem;  // reason for a missing preview, from the client's output
};

class SceneList {
 public:
  /// Lists the scene files (*.toml) in the folder, sorted by the scenes' names. `cache`: folder in which
  /// rendered preview images are stored.
  SceneList(const std::filesystem::path& folder, std::filesystem::path cache);

  /// Adds the scene file to the list, unless it is listed already, and returns its index. Throws InputError
  /// if it can't be read or is not a scene.
  std::size_t add(const std::filesystem::path& file);
  /// Loads the preview images one after the other, without waiting. A missing one is rendered by a client
  /// process.
  void poll();
  const std::vector<ListedScene>& scenes() const { return scenes_; }

 private:
  std::vector<ListedScene> scenes_;
  std::filesystem::path cache_;
  std::size_t next_ = 0;                 // next scene to get a preview
  std::unique_ptr<ChildProcess> draws_;  // renders its preview

  std::filesystem::path picture_of(const ListedScene& scene) const;
};

}  // namespace prosector
