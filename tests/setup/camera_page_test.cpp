// The camera's page: a synthetic camera is shown a board.
#include "client/setup/camera_page.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drivers/camera/base/camera_calibration.h"
#include "tests/folders.h"
#include "tests/setup/pages_room.h"

namespace prosector::test {
namespace {

const std::string shipped_camera = "synthetic:" + source_path("deploy/cameras/calibrate.toml");
constexpr double true_focal = 612;  // px, as that scene has it
constexpr int views_that_do = 7;

struct CameraFolder : TemporaryFile {
  using TemporaryFile::TemporaryFile;
  ~CameraFolder() { std::filesystem::remove_all(path); }
};

void look(PagesRoom& room, const std::string& address) {
  room.click("Camera");
  room.type("camera address", address);
}

TEST(CameraPage, FindsALensAndNamesItInTheDraft) {
  PagesRoom room("# none\n", 1);
  look(room, shipped_camera);
  room.until([&] { return room.find("camera picture") != nullptr; });
  room.click("calibrate");
  room.until([&] { return room.find("reported: views 3") != nullptr; });
  room.picture("camera-guide-1x");
  room.until([&] { return room.find("fit now") != nullptr && room.reported("views ") >= views_that_do; });
  room.click("fit now");
  EXPECT_EQ(room.said().words, "Fitting …") << "the window goes on meanwhile";
  room.until([&] { return room.draft().changed(); });
  room.picture("camera-done-1x");
  EXPECT_EQ(room.said().words, "Done.");
  ASSERT_TRUE(room.draft().changed());
  EXPECT_TRUE(room.draft().config().tracker_device.camera.lens.ends_with("camera.toml"));
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
    for (const ConfigChange& change : lens_changes(config, "1")) keys += change.key + " ";
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
  EXPECT_NE(room.find("camera trouble: Too dark: add light."), nullptr);
}

TEST(CameraPage, NothingIsCutOffWhereLettersAreLarge) {
  for (const double wide : {1., 2.}) {
    PagesRoom room("# none\n", 2, wide);
    look(room, shipped_camera);
    room.until([&] { return room.find("camera picture") != nullptr; });
    room.click("calibrate");
    room.draw(20);
    room.picture(wide == 1 ? "camera-narrow" : "camera-2x");
    for (const PlacedControl& c : room.placed()) EXPECT_LE(c.right, room.width() - 16) << c.name;
  }
}

// Tabs are gone through by arrows, fields by Tab, and buttons pressed by Space.
TEST(CameraPage, TheKeyboardAloneSuffices) {
  PagesRoom room("[tracker]\naddress = \"tags:" + shipped_camera + "\"\n", 1);
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
