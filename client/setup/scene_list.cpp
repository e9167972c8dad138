#include "client/setup/scene_list.h"

#include <fmt/format.h>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>
#include <chrono>

#include "common/error.h"
#include "common/regular_file.h"
#include "common/toml_nesting.h"

namespace prosector {
namespace {

constexpr const char* picture_size = "480x270";
constexpr std::size_t most_bytes = 1 << 20;  // of a scene file

/// Reads a scene's name and description. Throws InputError if the file is not TOML or not a scene.
ListedScene read_heading(const std::filesystem::path& file) {
  ListedScene out;
  out.file = file;
  const std::string text = read_regular_file(file, most_bytes);
  check_nesting(text, file.string());
  try {
    const toml::table table = toml::parse(text, file.string());
    out.name = table["name"].value_or(file.stem().string());
    out.description = table["description"].value_or(std::string());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
  return out;
}

}  // namespace

SceneList::SceneList(const std::filesystem::path& folder, std::filesystem::path cache)
    : cache_(std::move(cache)) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".toml") continue;
    try {
      scenes_.push_back(read_heading(entry.path()));
    } catch (const InputError&) {  // not a scene, so not listed
    }
  }
  std::sort(scenes_.begin(), scenes_.end(),
            [](const ListedScene& a, const ListedScene& b) { return a.name < b.name; });
}

std::size_t SceneList::add(const std::filesystem::path& file) {
  const std::filesystem::path whole = std::filesystem::absolute(file);
  const auto known = std::find_if(scenes_.begin(), scenes_.end(),
                                  [&](const ListedScene& scene) { return scene.file == whole; });
  if (known != scenes_.end()) return static_cast<std::size_t>(known - scenes_.begin());
  scenes_.push_back(read_heading(whole));
  return scenes_.size() - 1;
}

/// Returns the path of a scene's cached preview. It contains the file's modification time, so that a changed
/// scene gets a new preview.
std::filesystem::path SceneList::picture_of(const ListedScene& scene) const {
  std::error_code error;
  const auto written = std::filesystem::last_write_time(scene.file, error).time_since_epoch().count();
  return cache_ / "pictures" / fmt::format("{}", written) /
         fmt::format("{}-scene.png", scene.file.stem().string());
}

void SceneList::poll() {
  if (next_ >= scenes_.size()) return;
  ListedScene& scene = scenes_[next_];
  const std::filesystem::path picture = picture_of(scene);
  if (!draws_ && !std::filesystem::exists(picture)) {
    try {
      draws_ = std::make_unique<ChildProcess>(std::vector<std::string>{
          "nice", "-n", "10", program_folder() / "prosector-client", "render", scene.file, "--out",
          picture.parent_path(), "--view", "scene", "--size", picture_size});
    } catch (const InputError& error) {
      scene.problem = error.what();
      ++next_;
    }
    return;
  }
  if (draws_) {
    draws_->poll();
    if (!draws_->ended()) return;
  }
  try {
    scene.picture = read_png(picture);
  } catch (const InputError& error) {
    scene.problem = draws_ && !draws_->lines().empty() ? draws_->lines().back() : error.what();
  }
  draws_.reset();
  ++next_;
}

}  // namespace prosector
