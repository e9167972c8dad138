// Several who look by one camera.

#include "drivers/camera/devices/shared_camera.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "common/error.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;

/// Writes a small, fast scene, and returns its address.
std::string scene_address(const char* name, const std::string& more = "") {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / name;
  std::ofstream(file)
      << "[[camera]]\nwidth = 32\nheight = 24\nrate = 100\nrays = 1\nexposure = 0\ndelay = 0\n"
      << more;
  return "synthetic:" + file.string();
}

template <class Holds>
bool comes_true(const Holds& holds) {
  for (int wait = 0; wait < 500 && !holds(); ++wait) std::this_thread::sleep_for(10ms);
  return holds();
}

struct Looker {
  std::atomic<int> begun = 0, seen = 0;
  std::atomic<std::uint64_t> last = 0;

  std::unique_ptr<SharedCamera::Seat> sit(SharedCamera& camera) {
    return std::make_unique<SharedCamera::Seat>(
        camera, [this](const Camera&) { ++begun; },
        [this](const Frame& frame) {
          ++seen;
          last = frame.number;
        });
  }
};

TEST(SharedCamera, TellsEverySeatWhileItIsThere) {
  SharedCamera camera(scene_address("shared_all.toml"));
  Looker first, second;
  const auto seat = first.sit(camera);
  ASSERT_TRUE(comes_true([&] { return first.seen > 2; }));
  auto late = second.sit(camera);
  ASSERT_TRUE(comes_true([&] { return second.seen > 2; }));
  EXPECT_EQ(first.begun, 1);
  EXPECT_EQ(second.begun, 1);  // though the camera was open already
  late.reset();
  const int left = second.seen, before = first.seen;
  ASSERT_TRUE(comes_true([&] { return first.seen > before + 2; }));
  EXPECT_EQ(second.seen, left);
}

TEST(SharedCamera, SaysOfAPictureWhenAllSawIt) {
  SharedCamera camera(scene_address("shared_told.toml"));
  EXPECT_EQ(camera.reported_ns(), 0);
  std::atomic<std::int64_t> last_ns = 0;
  std::atomic<int> early = 0, pictures = 0;
  const auto look = [&](const Frame& frame) {
    if (camera.reported_ns() >= frame.time_ns) ++early;
    last_ns = frame.time_ns;
    ++pictures;
  };
  const SharedCamera::Seat one(
      camera, [](const Camera&) {}, look),
      two(
          camera, [](const Camera&) {}, look);
  ASSERT_TRUE(comes_true([&] { return pictures > 4; }));
  EXPECT_EQ(early, 0);
  const std::int64_t then = last_ns;
  EXPECT_TRUE(comes_true([&] { return camera.reported_ns() >= then; }));
}

TEST(SharedCamera, ReadsEachPictureOnceForAllOfOneLens) {
  SharedCamera camera(scene_address("shared_reader.toml"));
  const auto reader = camera.reader("");
  EXPECT_EQ(reader, camera.reader(""));
  std::atomic<int> pictures = 0, odd = 0;
  std::int64_t first_ns = 0;
  const SharedCamera::Seat one(
      camera, [&](const Camera& opened) { reader->begin(opened); },
      [&](const Frame& frame) { first_ns = reader->read(frame).time_ns; });
  const SharedCamera::Seat two(
      camera, [&](const Camera& opened) { reader->begin(opened); },
      [&](const Frame& frame) {
        if (reader->read(frame).time_ns != frame.time_ns || first_ns != frame.time_ns) ++odd;
        ++pictures;
      });
  ASSERT_TRUE(comes_true([&] { return pictures > 2; }));
  EXPECT_EQ(odd, 0);
  EXPECT_EQ(reader->changes(), 1);  // though both told it of the camera
}

TEST(SharedCamera, TellsWhoSitsBehindWhereTheCameraStood) {
  SharedCamera camera(scene_address("shared_place.toml"));
  std::atomic<int> pictures = 0, unknown = 0;
  const SharedCamera::Seat behind(
      camera, [](const Camera&) {},
      [&](const Frame&) {
        if (!camera.room_camera()) ++unknown;
        ++pictures;
      });
  ASSERT_TRUE(comes_true([&] { return pictures > 2; }));
  EXPECT_GT(unknown, 0);
  const SharedCamera::Seat before(
      camera, [](const Camera&) {},
      [&](const Frame&) {
        camera.set_room_camera({{1, 2, 3}, Quat::Identity()});
      },
      true);
  const int known_from = pictures;
  ASSERT_TRUE(comes_true([&] { return pictures > known_from + 3; }));
  const int unknown_then = unknown;
  ASSERT_TRUE(comes_true([&] { return pictures > known_from + 6; }));
  EXPECT_EQ(unknown, unknown_then);
}

TEST(SharedCamera, TellsOthersOfWhatOneCannotUse) {
  SharedCamera camera(scene_address("shared_fault.toml"));
  Looker other;
  const SharedCamera::Seat odd(
      camera, [](const Camera&) {}, [](const Frame&) { throw InputError("it is too small"); });
  const auto seat = other.sit(camera);
  ASSERT_TRUE(comes_true([&] { return other.seen > 2; }));
  EXPECT_TRUE(comes_true([&] { return camera.state().problem == "it is too small"; }));
}

TEST(SharedCamera, BeginsAnewForEachWhenTheCameraComesBack) {
  SharedCamera camera(
      scene_address("shared_back.toml", "[[fault]]\nkind = \"unplugged\"\nfrom = 0.2\nto = 0.3\n"));
  Looker one, two;
  const auto seat = one.sit(camera), beside = two.sit(camera);
  ASSERT_TRUE(comes_true([&] { return camera.state().opened == 2 && one.begun == 2 && two.begun == 2; }));
}

}  // namespace
}  // namespace prosector
