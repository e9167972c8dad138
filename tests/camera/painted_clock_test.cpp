// The clock in a synthetic camera's pictures.

#include "twins/camera/painted_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
#include <random>

#include "common/error.h"
#include "drivers/camera/base/camera.h"

namespace prosector {
namespace {

/// Reads the clock by its cells' middles; −1: they are no clock.
int read_clock(const Image& picture) {
  const int side = clock_cell(picture.width), left = (picture.width - side * clock_cells) / 2;
  const auto is_white = [&](int cell) {
    return picture.pixel(left + cell * side + side / 2, side / 2)[0] > 127;
  };
  int ms = 0;
  for (int bit = 0; bit < clock_bits; ++bit) ms |= (is_white(2 + bit) ? 1 : 0) << bit;
  const bool parity = std::popcount(static_cast<unsigned>(ms)) % 2 != 0;
  const bool whole =
      is_white(0) && !is_white(1) && is_white(clock_bits + 2) == parity && is_white(clock_bits + 3) != parity;
  return whole ? ms : -1;
}

std::filesystem::path clock_scene(const std::string& more) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "clock.toml";
  std::ofstream(file) << "[[camera]]\nrate = 100\nrays = 1\nexposure = 0\ndelay = 0\n" << more;
  return file;
}

TEST(PaintedClock, TellsAnyTimeInPicturesOfAnySize) {
  std::mt19937_64 random(4);
  for (const int width : {40, 41, 97, 320, 640, 1280})
    for (const int height : {1, 30, 480}) {
      const Image grey{width, height,
                       std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), 100)};
      for (int time = 0; time < 200; ++time) {
        Image picture = grey;
        const auto ns = static_cast<std::int64_t>(random() >> 2);
        paint_clock(picture, ns);
        const int side = clock_cell(width);
        if (height > side / 2) {
          EXPECT_EQ(read_clock(picture), (ns / 1'000'000) % 65536) << width << " " << height;
        }
        const auto painted =
            std::count_if(picture.rgb.begin(), picture.rgb.end(), [](auto b) { return b != 100; });
        EXPECT_EQ(painted, 3 * side * clock_cells * std::min(side, height)) << "no pixel beside it";
      }
    }
}

TEST(PaintedClock, CameraPaintsTheTimeOfItsFrames) {
  const auto camera =
      open_camera("synthetic:" + clock_scene("width = 80\nheight = 16\nclock = true\n").string());
  for (int k = 0; k < 5; ++k) {
    const auto frame = camera->next(std::chrono::seconds(5));
    ASSERT_TRUE(frame);
    EXPECT_EQ(read_clock(frame->image), (frame->time_ns / 1'000'000) % 65536);
  }
  const auto without = open_camera("synthetic:" + clock_scene("width = 80\nheight = 16\n").string());
  EXPECT_EQ(read_clock(without->next(std::chrono::seconds(5))->image), -1);
}

TEST(PaintedClock, RefusesPicturesThatAreTooSmall) {
  try {
    (void)open_camera("synthetic:" + clock_scene("width = 39\nheight = 16\nclock = true\n").string());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("clock"), std::string::npos);
  }
}

}  // namespace
}  // namespace prosector
