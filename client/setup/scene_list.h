#pragma once
// The scenes that come with the program, with a picture of each, drawn once by the program itself.

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
  std::string problem;  // why there is no picture, in the words of who drew it
};

class SceneList {
 public:
  /// Lists the scene files of a folder, by name, and others. Pictures are kept in `cache`.
  SceneList(const std::filesystem::path& folder, std::filesystem::path cache);

  /// Adds a scene file of somebody's own, or finds it, and returns its place. Throws InputError for one that
  /// can't be read or names no scene.
  std::size_t add(const std::filesystem::path& file);
  /// Goes on with drawing what has no picture yet, one after the other, without waiting.
  void poll();
  const std::vector<ListedScene>& scenes() const { return scenes_; }

 private:
  std::vector<ListedScene> scenes_;
  std::filesystem::path cache_;
  std::size_t next_ = 0;                 // to be given a picture
  std::unique_ptr<ChildProcess> draws_;  // that one

  std::filesystem::path picture_of(const ListedScene& scene) const;
};

}  // namespace prosector
