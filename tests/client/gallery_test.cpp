// The golden pictures, drawn by this renderer and looked at by a person. `update_gallery FOLDER` draws them
// anew.

#include "tests/client/gallery.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/client/picture.h"
#include "tests/folders.h"

namespace prosector {
namespace {

using namespace test;

// Another Mesa version may round differently, hardware may smooth edges differently: few pixels, small steps.
constexpr double max_mean_difference = 1.0;  // of 255
constexpr double max_share_beyond = 0.01;    // of the bytes may differ by more than
constexpr int visible_difference = 24;       // of 255

class Gallery : public testing::TestWithParam<std::string> {};

TEST_P(Gallery, LooksAsItDid) {
  const GalleryPicture picture = gallery_picture(GetParam());
  const std::filesystem::path golden =
      source_path("tests/client/golden/" + std::string(picture.name) + ".png");
  const Image expected = read_png(golden);
  const Image drawn = picture_of(picture.list, picture.width, picture.height);
  ASSERT_EQ(drawn.rgb.size(), expected.rgb.size());
  double sum = 0;
  std::size_t beyond = 0;
  for (std::size_t k = 0; k < drawn.rgb.size(); ++k) {
    const int difference = std::abs(drawn.rgb[k] - expected.rgb[k]);
    sum += difference;
    beyond += difference > visible_difference ? 1 : 0;
  }
  const auto size = static_cast<double>(drawn.rgb.size());
  const bool alike =
      sum / size <= max_mean_difference && static_cast<double>(beyond) / size <= max_share_beyond;
  if (alike) return;
  const auto file = std::filesystem::path(testing::TempDir()) / ("prosector_" + picture.name + ".png");
  write_png(drawn, file);
  ADD_FAILURE() << golden << " differs by " << sum / size << " on average, "
                << 100 * static_cast<double>(beyond) / size << " % visibly; drawn: " << file;
}

INSTANTIATE_TEST_SUITE_P(Pictures, Gallery, testing::ValuesIn(gallery_names()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace prosector
