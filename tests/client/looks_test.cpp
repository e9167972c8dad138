// How bright every shipped scene is from its own camera: nothing burns out, nothing drowns, and the anatomy
// lies where an eye sees most.

#include <gtest/gtest.h>

#include <algorithm>

#include "client/view/scene_tour.h"
#include "client/view/still_scene.h"
#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "tests/client/picture.h"
#include "tests/folders.h"

namespace prosector {
namespace {

using namespace test;

constexpr int width = 400, height = 300;
constexpr double most_clipped = 0.01, most_dark = 0.10;        // of the picture
constexpr int clipped_from = 254, dark_below = 8;              // of 255
constexpr double darkest_median = 55, brightest_median = 190;  // of 255: of the anatomy's luminance

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("deploy/scenes")))
    if (entry.path().extension() == ".toml") out.push_back(entry.path().stem().string());
  std::sort(out.begin(), out.end());
  return out;
}

/// Returns the share of the picture's pixels of which `is_so` holds.
template <class Test>
double share(const Image& image, const Test& is_so) {
  std::size_t count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += is_so(image.pixel(x, y)) ? 1 : 0;
  return static_cast<double>(count) / (static_cast<double>(image.width) * image.height);
}

bool is_anatomy(const DrawItem& item) {
  const Surface surface = item.appearance.surface;
  return surface == Surface::tissue || surface == Surface::bone || surface == Surface::skin;
}

/// Returns the list with the anatomy white and everything else black.
DrawList masked(DrawList list) {
  list.ambient = list.background = Vec3::Zero();
  for (DrawItem& item : list.items) {
    const bool white = is_anatomy(item);
    item.appearance = {.color = white ? Vec3::Constant(100) : Vec3::Zero(), .surface = Surface::emissive};
  }
  return list;
}

/// Returns the middle one of the luminances where the mask is white; a negative number where it is nowhere.
double median_luminance(const Image& image, const Image& mask) {
  std::vector<double> values;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (mask.pixel(x, y)[1] > 200) values.push_back(luminance(image.pixel(x, y)));
  if (values.empty()) return -1;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class Looks : public testing::TestWithParam<std::string> {};

TEST_P(Looks, OfAShippedSceneAreNeitherBurntNorDark) {
  const SceneDesc scene = load_scene(source_path("deploy/scenes/" + GetParam() + ".toml"));
  const SourcePaths paths{scene.file.parent_path(), {default_data_dir()}, default_cache_dir()};
  const DrawList still = still_scene(scene, paths, [](const std::string&) {});
  const DrawList list = tour_of(scene, still, width, height).front().list;
  const Image picture = picture_of(list, width, height);
  const auto all_channels = [](const std::uint8_t* rgb, const auto& test) {
    return test(rgb[0]) && test(rgb[1]) && test(rgb[2]);
  };
  EXPECT_LE(share(picture,
                  [&](const std::uint8_t* rgb) {
                    return all_channels(rgb, [](int value) { return value >= clipped_from; });
                  }),
            most_clipped);
  EXPECT_LE(share(picture,
                  [&](const std::uint8_t* rgb) {
                    return all_channels(rgb, [](int value) { return value < dark_below; });
                  }),
            most_dark);
  RendererSettings plain;
  plain.effects.reset();
  const double median =
      median_luminance(picture, picture_of(masked(list), width, height, make_offscreen_context, plain));
  if (median < 0) return;  // a scene without anatomy
  EXPECT_GE(median, darkest_median);
  EXPECT_LE(median, brightest_median);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Looks, testing::ValuesIn(shipped_scenes()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace prosector
