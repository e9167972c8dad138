#pragma once
// Reloads a scene when its files change, in the background of the session that runs on the old one.

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "common/scene/scene.h"
#include "server/session/run/ready_scene.h"

namespace prosector {

class SceneReloader {
 public:
  struct Hooks {
    std::function<ReadyScene()> load;  // reads and compiles the scene again; throws InputError
    std::function<void()> ready;       // called when a new scene is available from take()
    std::function<void(const std::string&)> say;
  };

  /// Watches the scene's file, the tables and meshes that it names, and the folders where these would be
  /// searched (`data_dirs`). After a change it loads the scene on a separate thread. A failure to load is
  /// reported once per change.
  SceneReloader(const SceneDesc& scene, std::vector<std::filesystem::path> data_dirs, Hooks hooks);

  /// Returns the newly compiled scene after its files changed. Returns none if there is none or it was
  /// already taken.
  std::optional<ReadyScene> take();

 private:
  Hooks hooks_;
  std::vector<std::filesystem::path> data_dirs_;
  std::mutex mutex_;
  std::optional<ReadyScene> made_;
  std::jthread thread_;  // last member: it ends before the data that it uses

  void run(const std::stop_token& stop, const std::filesystem::path& file);
  std::vector<std::filesystem::path> files_of(const std::filesystem::path& file) const;
  void reload();
};

}  // namespace prosector
