// The page of the screen that is a window: a face of our own before a synthetic camera is told where it is.
#include "client/setup/window_page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "client/setup/eye_position_view.h"
#include "tests/real_data.h"
#include "tests/setup/pages_room.h"

namespace prosector::test {
namespace {

const Vec3 true_eyes(0.06, 0.06, 0.6);  // m, before the screen; lower, the chin were out of the picture
constexpr double camera_up = 0.17;      // m, over its middle

/// A folder with the scene of a still face before a camera at a screen.
struct FaceFolder : TemporaryFile {
  using TemporaryFile::TemporaryFile;
  ~FaceFolder() { std::filesystem::remove_all(path); }
  std::string camera(const std::string& more = "") const {
    write_file(path / "face.toml",
               fmt::format("[[camera]]\nrate = 10\nrays = 1\nposition = [0, {}, 0]\norientation = [0, 0, 1, "
                           "0]\n[[face]]\nposition = [{}, {}, {}]\neye_distance = 0.07\n{}",
                           camera_up, true_eyes.x(), true_eyes.y(), true_eyes.z(), more));
    return "face:synthetic:" + (path / "face.toml").string();
  }
};

/// Returns the trouble that the page tells; "?": it shows none of a camera.
std::string shown_problem(const PagesRoom& room) {
  const std::string words = "window trouble: ";
  for (const PlacedControl& c : room.placed())
    if (c.name.starts_with(words)) return c.name.substr(words.size());
  return "?";
}

bool is_seen(const PagesRoom& room) {
  return std::any_of(room.placed().begin(), room.placed().end(),
                     [](const PlacedControl& c) { return c.name.starts_with("reported: eyes "); });
}

TEST(EyesShown, AreSaidAsARulerTellsThem) {
  const ScreenGeometry screen = {0.3, {0, 0.2, 0}};
  EXPECT_EQ(distance_text({}, {0, -0.1, 0.4}, screen),
            "500 mm from the camera and 412 mm from the screen centre to the eyes");
  EXPECT_EQ(direction_text({}, {0.05, -0.02, 0.5}),
            "Eyes, from the screen centre: 50 mm to the right (6°), 20 mm below (2°), 500 mm in front");
  EXPECT_EQ(direction_text({}, {-0.5, 0.5, 0.5}),
            "Eyes, from the screen centre: 500 mm to the left (45°), 500 mm above (45°), 500 mm in front");
}

TEST(WindowPage, SaysWhatIsWrongWithTheCameraAndAsksForItFirst) {
  PagesRoom room("# none\n", 1);
  room.click("Window");
  EXPECT_EQ(room.find("height"), nullptr) << "there is no camera yet";
  room.type("window.address", "mirror:0");
  EXPECT_NE(room.said().words.find("unknown driver"), std::string::npos) << room.said().words;
  EXPECT_TRUE(room.said().wrong);
  const std::filesystem::path empty = std::filesystem::temp_directory_path() / "prosector-no-data";
  const char* data = std::getenv("PROSECTOR_DATA");
  const std::string before = data == nullptr ? "" : data;
  setenv("PROSECTOR_DATA", empty.c_str(), 1);
  room.type("window.address", "face:/dev/no-such-camera");
  room.until([&] { return shown_problem(room) != "?"; });
  data == nullptr ? unsetenv("PROSECTOR_DATA") : setenv("PROSECTOR_DATA", before.c_str(), 1);
  EXPECT_NE(shown_problem(room).find("deploy/fetch_models.sh"), std::string::npos) << shown_problem(room);
  EXPECT_NE(room.find("height"), nullptr);
}

class FacePage : public testing::Test {
 protected:
  void SetUp() override {
    if (find_in_data("face_short_range.tflite").empty())
      GTEST_SKIP() << "no face_short_range.tflite: deploy/fetch_models.sh";
  }
};

TEST_F(FacePage, NamesNoCameraAndNoFace) {
  const FaceFolder folder("faceless");
  write_file(folder.path / "empty.toml",
             "[[camera]]\nrate = 10\nrays = 1\nwidth = 320\nheight = 240\nfocal = 300\n");
  PagesRoom room("[window]\naddress = \"face:/dev/no-such-camera\"\n", 1);
  room.click("Window");
  room.until([&] { return shown_problem(room).find("no-such-camera") != std::string::npos; });
  EXPECT_NE(shown_problem(room).find("no-such-camera"), std::string::npos);
  EXPECT_FALSE(is_seen(room));
  room.type("window.address", "face:synthetic:" + (folder.path / "empty.toml").string());
  room.until([&] { return shown_problem(room).find("no face detected") != std::string::npos; });
  EXPECT_NE(shown_problem(room).find("no face detected"), std::string::npos) << shown_problem(room);
  EXPECT_FALSE(is_seen(room));
}

TEST_F(FacePage, TellsWhereTheEyesAreAndWritesWhatARulerSaid) {
  const FaceFolder folder("faced");
  PagesRoom room("# my screen\n", 1);
  room.click("Window");
  room.type("window.address", folder.camera());
  room.type("height", "320");
  room.type("camera up", "170");
  room.type("eyes apart", "70");
  EXPECT_FALSE(room.said().wrong) << room.said().words;
  const ClientConfig& config = room.draft().config();
  EXPECT_EQ(config.window.height, 0.32);
  EXPECT_EQ(config.window.device.placement.room_device.p, Vec3(0, camera_up, 0));
  EXPECT_EQ(config.eyes.distance, 0.07);
  room.until([&] { return is_seen(room); });
  ASSERT_TRUE(is_seen(room)) << shown_problem(room);
  room.picture("window-1x");
  const double from_camera = 1e3 * (true_eyes - Vec3(0, camera_up, 0)).norm();
  EXPECT_NEAR(room.reported("eyes "), from_camera, 60) << "mm: one that isn't calibrated errs by a tenth";
  EXPECT_LT(room.control("save").bottom, room.height() - 40) << "it is seen without a wheel";
  room.click("save");
  const ClientConfig saved = load_client_config(room.draft().file());
  EXPECT_EQ(saved.window.address, config.window.address);
  EXPECT_EQ(saved.window.height, 0.32);
  EXPECT_EQ(saved.window.device.face.eye_distance, 0.07);
  EXPECT_TRUE(read_file(room.draft().file()).starts_with("# my screen\n"));
  // Eyes that are told to be half as far apart are half as far away: what is typed counts at once.
  room.type("eyes apart", "35");
  room.until([&] { return is_seen(room) && room.reported("eyes ") < 0.7 * from_camera; });
  EXPECT_LT(room.reported("eyes "), 0.7 * from_camera);
}

// Who moves to the button while the camera loses their face must not miss it.
TEST_F(FacePage, NothingMovesWhenEyesAreFound) {
  const FaceFolder folder("moving");
  write_file(folder.path / "void.toml",
             "[[camera]]\nrate = 10\nrays = 1\nwidth = 320\nheight = 240\nfocal = 300\n");
  const std::string with_a_face = folder.camera();
  PagesRoom room("# my screen\n", 1);
  room.click("Window");
  room.type("window.address", "face:synthetic:" + (folder.path / "void.toml").string());
  room.until([&] { return shown_problem(room).find("no face detected") != std::string::npos; });
  ASSERT_FALSE(is_seen(room));
  const PlacedControl without = room.control("save");
  room.type("window.address", with_a_face);
  room.until([&] { return is_seen(room); });
  ASSERT_TRUE(is_seen(room));
  EXPECT_EQ(room.control("save").top, without.top);
  EXPECT_EQ(room.control("save").left, without.left);
}

TEST_F(FacePage, RefusesWhatNoScreenHasAndKeepsTheRest) {
  const FaceFolder folder("refused");
  PagesRoom room("[window]\naddress = \"" + folder.camera() + "\"\n", 1);
  room.click("Window");
  room.type("height", "1");
  EXPECT_TRUE(room.said().wrong);
  EXPECT_NE(room.said().words.find("window.height: must be a number from 0.05 to 10"), std::string::npos)
      << room.said().words;
  EXPECT_EQ(room.draft().config().window.height, WindowSettings().height);
  room.type("looks down", "10");
  const Quat down = room.draft().config().window.device.placement.room_device.q;
  EXPECT_LT((down * -Vec3::UnitZ() - Vec3(0, -std::sin(0.1745329), std::cos(0.1745329))).norm(), 1e-6);
  room.click("mode pan");
  EXPECT_TRUE(room.draft().config().window.pans);
  // A session isn't entered by two pictures while a camera is named.
  room.click("Pictures");
  room.click("display stereo:5dt_hmd_800_26");
  room.click("Window");
  room.draw();
  ASSERT_NE(room.find("in a window"), nullptr);
  room.click("in a window");
  EXPECT_EQ(room.find("in a window"), nullptr);
}

TEST_F(FacePage, NothingIsCutOffWhereLettersAreLarge) {
  const FaceFolder folder("wide_face");
  const std::string camera = folder.camera();
  for (const double wide : {1., 2.}) {
    PagesRoom room("[window]\naddress = \"" + camera + "\"\n", 2, wide);
    room.click("Window");
    room.until([&] { return is_seen(room); });
    room.picture(wide == 1 ? "window-narrow" : "window-2x");
    for (const PlacedControl& c : room.placed()) EXPECT_LE(c.right, room.width() - 16) << c.name;
  }
}

}  // namespace
}  // namespace prosector::test
