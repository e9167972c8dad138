#include "client/app/output/picture_time.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "client/render/renderer.h"
#include "client/view/camera.h"
#include "client/view/level_of_detail.h"
#include "client/view/scene_tour.h"
#include "client/view/still_scene.h"
#include "common/paths.h"
#include "common/scene/load_scene.h"

namespace prosector {
namespace {

constexpr int picture_width = 800, picture_height = 600;

}  // namespace

double picture_time(GlContext& context, const std::filesystem::path& shaders,
                    const std::filesystem::path& scene) {
  const SourcePaths paths{scene.parent_path(), {default_data_dir()}, default_cache_dir()};
  const auto in_silence = [](const std::string&) {};
  const SceneDesc desc = load_scene(scene);
  const DrawList still = still_scene(desc, paths, in_silence);
  DrawList list = tour_of(desc, still, picture_width, picture_height).front().list;
  Renderer renderer(context, shaders, quality_levels[1].settings);
  std::array<double, 7> seconds{};
  renderer.picture_of(list, picture_width, picture_height);  // compiles shaders and uploads meshes
  for (double& s : seconds) {
    const auto begin = std::chrono::steady_clock::now();
    renderer.picture_of(list, picture_width, picture_height);
    s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
  return seconds[seconds.size() / 2];
}

}  // namespace prosector
