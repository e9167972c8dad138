#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "common/clock.h"
#include "common/error.h"
#include "drivers/camera/base/image_reader.h"
#include "drivers/camera/base/undistorter.h"
#include "drivers/camera/tags/board_tracker.h"
#include "drivers/config/device_config.h"
#include "drivers/device/driver_table.h"
#include "tests/camera/tag_errors.h"
#include "tests/folders.h"

namespace prosector {
namespace {

const std::string printed_picture = source_path("tests/camera/atlas.png");

/// A page of an atlas, 200 mm wide.
Board atlas_page() {
  return {"atlas", {}, std::make_shared<const PrintedImage>(PrintedImage{read_image(printed_picture), 0.2})};
}

struct PictureRow {
  double distance, least_tilt, most_tilt;  // m, degrees
  double covered, light;
  double depth_mm, turn_deg;  // medians that are allowed
};

class PictureBoard : public testing::TestWithParam<PictureRow> {};

TEST_P(PictureBoard, IsFoundWhereItIs) {
  const PictureRow& row = GetParam();
  TagCase what{atlas_page()};
  what.distance = row.distance;
  what.least_tilt = row.least_tilt * degree;
  what.most_tilt = row.most_tilt * degree;
  what.covered = row.covered;
  what.light = row.light;
  what.places = 6;
  const TagErrors errors = tag_errors(what);
  std::cout << row.distance << " m: " << errors.seen << " of " << what.places << ", depth "
            << quantile(errors.depth, 0.5) << " / " << quantile(errors.depth, 0.95) << " mm, lateral "
            << quantile(errors.lateral, 0.5) << ", turn " << quantile(errors.turn, 0.5) / degree << ", told "
            << quantile(errors.told, 0.5) << "; ms " << quantile(errors.find_ms, 0.5) << " "
            << quantile(errors.fit_ms, 0.5) << "\n";
  EXPECT_EQ(errors.seen, what.places);
  EXPECT_LE(quantile(errors.depth, 0.5), row.depth_mm);
  EXPECT_LE(quantile(errors.turn, 0.5), row.turn_deg * degree);
}

INSTANTIATE_TEST_SUITE_P(Table, PictureBoard,
                         testing::Values(PictureRow{0.4, 0, 20, 0, 1, 0.2, 0.1},
                                         PictureRow{0.6, 0, 40, 0, 1, 0.4, 0.2},
                                         PictureRow{0.9, 0, 40, 0, 1, 3, 0.6},
                                         PictureRow{0.6, 50, 50, 0, 1, 0.5, 0.3}));

std::filesystem::path print_folder() {
  const std::filesystem::path out = std::filesystem::path(testing::TempDir()) / "prosector_picture_boards";
  std::filesystem::create_directories(out);
  return out;
}

std::filesystem::path written_file(const std::string& name, const std::string& text) {
  std::ofstream(print_folder() / name) << text;
  return print_folder() / name;
}

std::filesystem::path atlas_file() {
  return written_file("atlas.toml", "[picture]\nfile = \"" + printed_picture + "\"\nwidth = 0.2\n");
}

std::string refusal_of(const std::string& board) {
  try {
    (void)BoardTracker(load_board(written_file("bad.toml", board)));
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(PictureBoards, BadOnesAreRefusedInWords) {
  const auto grey_map = [](const std::string& name, auto shade) {  // a PGM
    std::string text = "P5 200 150 255\n";
    for (int y = 0; y < 150; ++y)
      for (int x = 0; x < 200; ++x) text += static_cast<char>(shade(x, y));
    return "[picture]\nfile = \"" + written_file(name, text).string() + "\"\nwidth = 0.2\n";
  };
  struct Row {
    std::string text, says;
  };
  const Row rows[] = {
      {"[picture]\nfile = \"nowhere.png\"\nwidth = 0.2\n", "nowhere.png: not a readable image"},
      {"[picture]\nfile = \"bad.toml\"\nwidth = 0.2\n", "bad.toml: not a readable image"},
      {"[picture]\nfile = \"" + printed_picture + "\"\n", "width: "},
      {"[picture]\nfile = \"" + printed_picture + "\"\nwidth = 0\n", "width: must be a number from 0.02"},
      {"[picture]\nwidth = 0.2\n", "file: "},
      {"[grid]\ncolumns = 1\nrows = 1\nsize = 0.1\nfirst = 0\n[picture]\nfile = \"" + printed_picture +
           "\"\nwidth = 0.2\n",
       "tags or one picture"},
      {grey_map("plain.pgm", [](int, int) { return 200; }), "distinguishable features"},
      {grey_map("chess.pgm", [](int x, int y) { return (x / 10 + y / 10) % 2 == 0 ? 20 : 230; }),
       "distinguishable features"},
      {grey_map("slope.pgm", [](int x, int) { return x; }), "distinguishable features"}};
  for (const Row& row : rows) {
    const std::string said = refusal_of(row.text);
    EXPECT_NE(said.find(row.says), std::string::npos) << said;
  }
}

// It moves before the camera, is hidden, and comes back: followed from picture to picture it stays where it
// is.
TEST(PictureBoards, AreFollowedAndComeBack) {
  SyntheticScene scene = usual_scene(usual_lens());
  scene.rays = 2;
  const Board board = load_board(atlas_file());
  Carrier carrier;
  carrier.motion.emplace();
  carrier.motion->add(0, 0, Pose{{-0.08, 0.02, -0.6}, Quat::Identity()});
  carrier.motion->add(0, 1, Pose{{0.08, -0.02, -0.55}, Quat(Eigen::AngleAxisd(0.4, Vec3::UnitY()))});
  const std::size_t index = scene.add_board(board, carrier);
  const Undistorter straightener(scene.lens);
  BoardTracker tracker(board);
  int seen = 0;
  for (std::uint64_t k = 0; k < 28; ++k) {
    const double seconds = scene.seconds_of(k);
    const bool hidden = k >= 12 && k < 15;
    const Image image = hidden ? Image{640, 480, std::vector<std::uint8_t>(640 * 480 * 3, 60)}
                               : SceneRenderer(scene).paint_at(seconds, k);
    TagImage picture{grey_of(image), {}, {}, static_cast<std::int64_t>(1e9 * seconds)};
    picture.straight = straightener.straight(picture.bent);
    const auto at = tracker.update(picture, {scene.lens, straightener.lens(), scene.sensor.response});
    if (hidden) {
      EXPECT_FALSE(at) << k;
    }
    if (!at) continue;
    ++seen;
    EXPECT_FALSE(at->followed);
    EXPECT_TRUE(at->spread);
    const SyntheticTruth truth = scene.truth(seconds);
    const Pose right = truth.room_camera.inverse() * truth.room_things[index];
    EXPECT_LT((at->camera_board.p - right.p).norm(), 1.5e-3) << k;
    EXPECT_LT(at->camera_board.q.angularDistance(right.q), 1 * degree) << k;
  }
  EXPECT_GE(seen, 18) << "after it was hidden it is searched within a fifth of a second";
}

TEST(PictureBoards, AreATrackersStations) {
  const auto scene = written_file(
      "scene.toml", "[camera]\nrays = 2\n[[board]]\nfile = \"atlas.toml\"\nposition = [0.03, 0.01, -0.5]\n");
  DeviceConfig config;
  config.tags.boards[0] = atlas_file().string();
  const auto device = open_device("tags:synthetic:" + scene.string(), config);
  std::vector<DeviceSample> samples;
  const std::int64_t end_ns = monotonic_ns() + 20'000'000'000;
  while (samples.size() < 3 && monotonic_ns() < end_ns) {
    device->poll(samples);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_GE(samples.size(), 3u) << device->status().message;
  EXPECT_LT((samples.back().pose.p - Vec3(0.03, 0.01, -0.5)).norm(), 2e-3);
}

}  // namespace
}  // namespace prosector
