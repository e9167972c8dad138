#include "client/render/image.h"

#include <gtest/gtest.h>

#include <fstream>

#include "client/render/contact_sheet.h"
#include "client/render/timed_sheet.h"
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

Image plain(int width, int height, std::uint8_t gray) {
  return {width, height,
          std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                                    gray)};
}

TEST(Image, AContactSheetShowsEveryPictureInItsPlace) {
  Image striped = plain(8, 4, 0);  // columns black and white in turn: gray when made half as wide
  for (std::size_t k = 0; k < striped.rgb.size(); ++k) striped.rgb[k] = (k / 3) % 2 == 0 ? 0 : 255;
  const Image sheet = contact_sheet({plain(8, 4, 200), plain(8, 4, 100), striped}, 2, 4);
  ASSERT_EQ(sheet.width, 3 * 4 + 2 * 4);
  ASSERT_EQ(sheet.height, 3 * 4 + 2 * 2);
  EXPECT_EQ(sheet.pixel(4, 4)[0], 200);
  EXPECT_EQ(sheet.pixel(12, 5)[1], 100);
  EXPECT_EQ(sheet.pixel(4, 10)[2], 128);
  EXPECT_EQ(sheet.pixel(12, 10)[0], sheet.pixel(0, 0)[0]) << "no fourth picture";
  EXPECT_THROW(contact_sheet({}, 2, 4), std::invalid_argument);
}

TEST(TimedSheet, TakesAPictureWhenOneIsDueAndKeepsTheirOrder) {
  TimedSheet timed(10);
  EXPECT_THROW(timed.sheet(), std::invalid_argument);
  const std::vector<std::pair<double, std::uint8_t>> pictures = {{0.4, 10}, {3, 20},  {9.9, 30}, {10.1, 40},
                                                                 {19, 50},  {35, 60}, {39, 70},  {40, 80}};
  for (const auto& [seconds, gray] : pictures) timed.take(plain(480, 240, gray), seconds);
  ASSERT_EQ(timed.pictures(), 4u);  // of 0 … 10 s, 10 … 20, 30 … 40 and 40 … 50
  EXPECT_FALSE(timed.wants(49.9));
  EXPECT_TRUE(timed.wants(50));
  const Image sheet = timed.sheet();
  EXPECT_EQ(sheet.height, 2 * 4 + 120);
  const std::array<int, 4> expected = {10, 40, 60, 80};
  for (int k = 0; k < 4; ++k)
    EXPECT_EQ(sheet.pixel(4 + 244 * k + 100, 60)[0], expected[static_cast<std::size_t>(k)]);
}

}  // namespace
}  // namespace prosector
