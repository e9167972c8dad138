#pragma once
// A scene that is made ready again when its files change, beside the session that runs on the old one.

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "common/scene/scene.h"
#include "server/session/ready_scene.h"

namespace prosector {

class SceneReloader {
 public:
  struct Hooks {
    std::function<ReadyScene()> load;  // reads and compiles the scene anew; throws InputError
    std::function<void()> ready;       // called when a new scene is there to take()
    std::function<void(const std::string&)> say;
  };

  /// Watches the scene's file, the tables and meshes that it names, and where they would be (`data_dirs`).
  /// Loads on a thread of its own; what does not load is told of, once per change.
  SceneReloader(const SceneDesc& scene, std::vector<std::filesystem::path> data_dirs, Hooks hooks);

  /// Takes the new scene; none: there is none, or it was taken.
  std::optional<ReadyScene> take();

 private:
  Hooks hooks_;
  std::vector<std::filesystem::path> data_dirs_;
  std::mutex mutex_;
  std::optional<ReadyScene> made_;
  std::jthread thread_;  // last: it ends before what it uses

  void run(const std::stop_token& stop, const std::filesystem::path& file);
  std::vector<std::filesystem::path> files_of(const std::filesystem::path& file) const;
  void reload();
};

}  // namespace prosector
