#include "client/render/image.h"

#include <gtest/gtest.h>

#include <fstream>

#include "common/error.h"

namespace prosector {
namespace {

std::filesystem::path temporary(const char* name) {
  return std::filesystem::path(testing::TempDir()) / name;
}

TEST(Image, PngRoundTrip) {
  Image image{7, 5, {}};
  for (int k = 0; k < 3 * 7 * 5; ++k) image.rgb.push_back(static_cast<std::uint8_t>(37 * k));
  const auto file = temporary("prosector_round_trip.png");
  write_png(image, file);
  EXPECT_TRUE(read_png(file) == image);
  std::filesystem::remove(file);
}

TEST(Image, RefusesWhatCannotBe) {
  const Image image{1, 1, {1, 2, 3}};
  EXPECT_THROW(write_png(image, "/nonexistent/folder/a.png"), InputError);
  EXPECT_THROW(write_png(image, "/dev/full"), InputError);
  EXPECT_TRUE(std::filesystem::exists("/dev/full")) << "a device that refuses must not be removed";
  EXPECT_THROW(write_png(Image{2, 2, {1}}, temporary("never.png")), InputError);
  EXPECT_THROW(read_png(temporary("missing.png")), InputError);
  const auto file = temporary("prosector_not_a.png");
  std::ofstream(file) << "not a picture";
  EXPECT_THROW(read_png(file), InputError);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace prosector
