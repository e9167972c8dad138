#include "server/session/run/scene_reloader.h"

#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <utility>

#include "common/anatomy/search_paths.h"
#include "common/error.h"
#include "common/scene/load_scene.h"
#include "server/session/run/file_watch.h"

namespace prosector {
namespace {

constexpr std::chrono::milliseconds between_looks{300};

}  // namespace

SceneReloader::SceneReloader(const SceneDesc& scene, std::vector<std::filesystem::path> data_dirs,
                             Hooks hooks)
    : hooks_(std::move(hooks)),
      data_dirs_(std::move(data_dirs)),
      thread_([this, file = scene.file](const std::stop_token& stop) { run(stop, file); }) {}

std::optional<ReadyScene> SceneReloader::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(made_, std::nullopt);
}

void SceneReloader::run(const std::stop_token& stop, const std::filesystem::path& file) {
  FileWatch watch([&] { return files_of(file); });
  std::mutex mutex;
  std::condition_variable_any asked_to_stop;
  std::unique_lock lock(mutex);
  while (!asked_to_stop.wait_for(lock, stop, between_looks, [&] { return stop.stop_requested(); }))
    if (watch.changed()) reload();
}

/// Returns the scene's file and those that it names now. A missing file is listed by its name alone, so that
/// its appearance is a change.
std::vector<std::filesystem::path> SceneReloader::files_of(const std::filesystem::path& file) const {
  std::vector<std::filesystem::path> out = {file};
  try {
    const SourcePaths paths{file.parent_path(), data_dirs_, {}};
    for (const std::string& name : referenced_files(load_scene(file))) {
      const auto found = find_source(name, paths);
      out.push_back(found.empty() ? std::filesystem::path(name) : found);
    }
  } catch (const InputError&) {
    // reload() reports the error.
  }
  return out;
}

void SceneReloader::reload() {
  hooks_.say("the scene's files have changed: reloading");
  try {
    ReadyScene made = hooks_.load();
    const std::lock_guard lock(mutex_);
    made_ = std::move(made);
  } catch (const std::exception& error) {
    hooks_.say(fmt::format("{}\nthe old scene continues", error.what()));
    return;
  }
  hooks_.ready();
}

}  // namespace prosector
