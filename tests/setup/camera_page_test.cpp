// The camera's page: a synthetic camera is shown a board, swiftly.
#include "client/setup/camera_page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "drivers/camera/camera_calibration.h"
#include "tests/setup/pages_room.h"

namespace prosector::test {
namespace {

constexpr double swiftness = 0.6;   // of the shipped motion's times
constexpr double true_focal = 612;  // px, as the shipped scene has it
constexpr int views_that_do = 7;

struct CameraFolder : TemporaryFile {
  using TemporaryFile::TemporaryFile;
  ~CameraFolder() { std::filesystem::remove_all(path); }
};

/// Writes the shipped scene with a swifter board into a folder. Returns the camera's address.
std::string swift_camera(const std::filesystem::path& folder) {
  const std::filesystem::path shipped = SHIPPED_CAMERAS;
  std::ifstream in(shipped / "shown_board.csv");
  std::string line, rows;
  std::getline(in, line);
  rows = line + "\n";
  while (std::getline(in, line)) {
    const std::size_t comma = line.find(',');
    rows += fmt::format("{:.4f}{}\n", swiftness * std::stod(line.substr(0, comma)), line.substr(comma));
  }
  write_file(folder / "shown_board.csv", rows);
  write_file(folder / "swift.toml", read_file(shipped / "calibrate.toml"));
  return "synthetic:" + (folder / "swift.toml").string();
}

void look(PagesRoom& room, const std::string& address) {
  room.click("Camera");
  room.type("camera address", address);
}

TEST(CameraPage, FindsALensAndNamesItInTheDraft) {
  const CameraFolder folder("swift_camera");
  PagesRoom room("# none\n", 1);
  look(room, swift_camera(folder.path));
  room.until([&] { return room.find("camera picture") != nullptr; });
  room.click("calibrate");
  room.until([&] { return room.find("told: views 3") != nullptr; });
  room.picture("camera-guide-1x");
  room.until([&] { return room.find("fit now") != nullptr && room.told("views ") >= views_that_do; });
  room.click("fit now");
  EXPECT_EQ(room.said().words, "Fitting …") << "the window goes on meanwhile";
  room.until([&] { return room.draft().changed(); });
  room.picture("camera-done-1x");
  EXPECT_EQ(room.said().words, "Done.");
  ASSERT_TRUE(room.draft().changed());
  EXPECT_TRUE(room.draft().config().tracker_device.lens.ends_with("camera.toml"));
  EXPECT_TRUE(room.draft().config().tracker.starts_with("tags:synthetic:"));
  const std::filesystem::path file = room.draft().file().parent_path() / "camera.toml";
  EXPECT_FALSE(std::filesystem::exists(file)) << "before it was asked for";
  EXPECT_LT(room.control("save").bottom, room.height() - 40) << "it is seen without a wheel";
  room.click("save");
  EXPECT_FALSE(room.draft().changed());
  const CameraCalibration found = load_calibration(file);
  EXPECT_NEAR(found.lens.fx, true_focal, 0.02 * true_focal);
  EXPECT_LT(found.error, 0.5);
}

TEST(CameraPage, NamesALensForWhatSeesByItsCamera) {
  const auto named = [](const char* tracker, const char* window) {
    ClientConfig config;
    config.tracker = tracker;
    config.window.address = window;
    std::string keys;
    for (const ConfigChange& change : naming_lens(config, "1")) keys += change.key + " ";
    return keys;
  };
  EXPECT_EQ(named("", ""), "tracker.lens tracker.address ");
  EXPECT_EQ(named("hands:1,2", ""), "tracker.lens ");
  EXPECT_EQ(named("hands:1", "face:1"), "window.lens tracker.lens ");
  EXPECT_EQ(named("", "face:1"), "window.lens ") << "it is no tracker";
  EXPECT_EQ(named("fastrak:/dev/ttyS0", "face:1"), "window.lens ");
  EXPECT_EQ(named("fastrak:/dev/ttyS0", "face:2"), "");
}

TEST(CameraPage, SaysWhatIsWrongAndComesBack) {
  const CameraFolder folder("dark_camera");
  const std::string scene = "[camera]\nfocal = 600\nlight = 0.02\n";
  write_file(folder.path / "dark.toml", scene);
  PagesRoom room("# none\n", 1);
  look(room, "/dev/no-such-camera");
  const auto named = [&] {
    return std::any_of(room.placed().begin(), room.placed().end(), [](const PlacedControl& c) {
      return c.name.starts_with("camera trouble: ") && c.name.find("no-such-camera") != std::string::npos;
    });
  };
  room.until(named);
  EXPECT_TRUE(named());
  EXPECT_EQ(room.find("camera picture"), nullptr);
  room.type("camera address", "synthetic:" + (folder.path / "dark.toml").string());
  room.until([&] { return room.find("camera picture") != nullptr; });
  room.draw();
  EXPECT_NE(room.find("camera trouble: It is too dark: make more light."), nullptr);
}

TEST(CameraPage, NothingIsCutOffWhereLettersAreLarge) {
  const CameraFolder folder("wide_camera");
  const std::string camera = swift_camera(folder.path);
  for (const double wide : {1., 2.}) {
    PagesRoom room("# none\n", 2, wide);
    look(room, camera);
    room.until([&] { return room.find("camera picture") != nullptr; });
    room.click("calibrate");
    room.draw(20);
    room.picture(wide == 1 ? "camera-narrow" : "camera-2x");
    for (const PlacedControl& c : room.placed()) EXPECT_LE(c.right, room.width() - 16) << c.name;
  }
}

// Tabs are gone through by arrows, fields by Tab, and buttons pressed by Space.
TEST(CameraPage, TheKeyboardAloneSuffices) {
  const CameraFolder folder("keyed_camera");
  PagesRoom room("[tracker]\naddress = \"tags:" + swift_camera(folder.path) + "\"\n", 1);
  room.click("Camera");
  room.press(640, 700);  // nothing is there
  for (int k = 0; k < 8 && room.find("camera picture") == nullptr; ++k) {
    room.tap(Key::down);
    room.tap(Key::space);
    room.draw(20);
  }
  room.until([&] { return room.find("camera picture") != nullptr; });
  EXPECT_NE(room.find("camera picture"), nullptr);
}

}  // namespace
}  // namespace prosector::test
