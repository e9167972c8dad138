// The set-up window's pages, drawn without a window and worked by events.
#include "client/setup/pages.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "drivers/device/field_map.h"
#include "tests/session/temporary_file.h"
#include "tests/setup/pages_room.h"
#include "tests/setup/written_file.h"

namespace prosector::test {
namespace {

constexpr const char* no_devices = "# none\n";

TEST(Pages, NothingOfThemIsBesideTheWindow) {
  for (const double scale : {1., 2.}) {
    PagesRoom room(no_devices, scale, scale);
    for (const char* page :
         {"Join", "Devices", "Tracker", "Glove", "Camera", "Window", "Pictures", "Checks"}) {
      room.click(page);
      room.picture(std::string(page) + (scale == 1 ? "-1x" : "-2x"));
      for (const PlacedControl& c : room.placed()) {
        EXPECT_GE(c.left, 0) << page << " " << c.name;
        EXPECT_LE(c.right, room.width()) << page << " " << c.name;
        EXPECT_LE(c.bottom, room.height()) << page << " " << c.name;
      }
    }
  }
}

// A window that is too narrow for both panels of a page has one below the other, and scrolls.
TEST(Pages, NothingIsCutOffAtItsRightWhereLettersAreLarge) {
  const struct {
    double scale;
    int wide, high;
  } windows[] = {{2, 1280, 720}, {1, 1280, 720}, {1, 1024, 600}, {2, 1920, 1080}, {1.5, 1366, 768}};
  for (const auto& [scale, wide, high] : windows) {
    for (const char* language : {"en", "de", "tr"}) {
      PagesRoom room(no_devices, scale, wide, high, language);
      for (const char* page :
           {"Join", "Devices", "Tracker", "Glove", "Camera", "Window", "Pictures", "Checks"}) {
        room.click(page);
        room.picture(fmt::format("{}-{}x{}-at-{}-{}", page, wide, high, scale, language));
        for (const PlacedControl& c : room.placed()) {
          EXPECT_LE(c.right, wide - 8 * scale)
              << language << " " << page << " " << c.name << " at " << wide << ", scale " << scale;
          EXPECT_GT(c.right - c.left, 2 * scale)
              << language << " " << page << " " << c.name << " at " << wide;
        }
      }
    }
  }
}

TEST(Pages, TheRulerFindsHowFarEyesAreApart) {
  PagesRoom room(no_devices, 1);
  room.click("Pictures");
  const PlacedControl& card = room.control("card");
  EXPECT_NEAR(card.right - card.left, 0.0856 / 0.265e-3, 1);
  room.click("reckon");
  EXPECT_EQ(room.said().words, "Done.");
  EXPECT_NEAR(room.draft().config().eyes.distance.value_or(0), 0.06, 1e-9) << "20 mm at 600 and 450 mm";
  room.picture("ruler");
  room.click("save");
  EXPECT_FALSE(room.draft().changed());
  // A press moves the mark that is nearer: at 150 mm the left eye's, which is too far from the other one.
  room.click("once more");
  const PlacedControl ruler = room.control("ruler");
  room.press(ruler.left + 150e-3 / 0.265e-3, (ruler.top + ruler.bottom) / 2);
  room.click("reckon");
  EXPECT_NE(room.said().words.find("usual are"), std::string::npos) << room.said().words;
  EXPECT_FALSE(room.draft().changed());
}

TEST(Pages, CrossesWantAHeadWithAReceiver) {
  PagesRoom room("[tracker]\naddress = \"fastrak:/nowhere\"\n", 1);
  room.click("Pictures");
  room.click("by crosses");
  room.picture("crosses-wishes");
  room.click("begin eyes");
  EXPECT_TRUE(room.said().wrong);
  EXPECT_NE(room.said().words.find("head"), std::string::npos) << room.said().words;
}

TEST(Pages, CrossesComeOverTheWholeWindowAndSpaceConfirms) {
  for (const double scale : {1., 2.}) {
    PagesRoom room("[tracker]\naddress = \"fastrak:/nowhere\"\nstations.head.station = 2\n", scale, scale);
    room.click("Pictures");
    room.click("by crosses");
    room.click("begin eyes");
    ASSERT_NE(room.find("covered"), nullptr);
    EXPECT_LT(room.control("covered").right, room.width() / 2) << "the left eye's first";
    room.tap(Key::space);
    room.picture(scale == 1 ? "crosses-1x" : "crosses-2x");
    EXPECT_EQ(room.said().words, "Cross 1 of 32") << "no head was still";
    EXPECT_NE(room.find("trouble"), nullptr);
    room.click("stop");
    EXPECT_EQ(room.find("covered"), nullptr);
    EXPECT_EQ(room.said().words, "Stopped. Nothing was changed.");
    EXPECT_FALSE(room.draft().changed());
  }
}

TEST(Pages, TakeAReceiverAndADeviceAwayByTheKeyboardToo) {
  PagesRoom room(
      "[tracker]\naddress = \"recorded:/nowhere.csv\"\n[tracker.stations]\nright.station = 1\nhead.station = "
      "2\n",
      1);
  room.click("Devices");
  room.click("tracker");
  room.click("free right");
  EXPECT_EQ(room.said().words, "No receiver is assigned to the right hand.");
  EXPECT_EQ(room.draft().config().stations[0], StationRole::none);
  EXPECT_EQ(room.find("free right"), nullptr);
  room.picture("freed");
  room.click("free head");
  EXPECT_TRUE(room.said().wrong) << "one is left at least";
  room.click("found tracker.address");
  for (const Key key : {Key::down, Key::up, Key::space}) room.tap(key);
  EXPECT_EQ(room.draft().config().tracker, "");
  EXPECT_EQ(room.said().words, "Tracker: none");
}

/// Writes what a tracker's receivers tell: the first goes away from the transmitter.
std::string going_away(const std::filesystem::path& file) {
  std::string rows = "time,station,x,y,z,qw,qx,qy,qz\n";
  for (int k = 0; k <= 400; ++k) {
    rows += fmt::format("{:.3f},1,{:.4f},0.1,-0.2,0.9914449,0,-0.1305262,0\n", 0.005 * k, 0.0025 * k);
    rows += fmt::format("{:.3f},2,-0.2,0.3,-0.1,1,0,0,0\n", 0.005 * k);
  }
  write_file(file, rows);
  return "recorded-loop:" + file.string();
}

TEST(TrackerRangePanel, TrustsWhatIsNearAndNothingWithAnError) {
  EXPECT_EQ(trust_at(0.1, ' '), Trust::good);
  EXPECT_EQ(trust_at(1.2, ' '), Trust::less);
  EXPECT_EQ(trust_at(3.5, ' '), Trust::none);
  EXPECT_EQ(trust_at(0.1, 'x'), Trust::none);
}

TEST(Pages, TellWhereReceiversAreAndWriteTheirSide) {
  const TemporaryFile poses("away.csv");
  for (const double scale : {1., 2.}) {
    PagesRoom room("[tracker]\naddress = \"" + going_away(poses.path) +
                       "\"\nhemisphere = [0, 0, -1]  # the ceiling\n[tracker.stations]\nright.station = "
                       "1\nhead.station = 2\n",
                   scale, scale);
    room.click("Tracker");
    std::set<std::string> seen;
    room.until([&] {
      for (const char* words : {"receiver 1 accurate", "receiver 1 less accurate"})
        if (room.find(words) != nullptr) seen.insert(words);
      return seen.size() == 2;
    });
    EXPECT_EQ(seen.size(), 2u);
    EXPECT_NE(room.find("receiver 2 accurate"), nullptr);
    room.picture(scale == 1 ? "range-1x" : "range-2x");
    room.click("behind");
    room.click("boresight");
    EXPECT_EQ(room.draft().config().tracker_device.fastrak.hemisphere, Vec3(-1, 0, 0));
    EXPECT_TRUE(room.draft().config().tracker_device.fastrak.boresight);
    room.picture(scale == 1 ? "range-changed-1x" : "range-changed-2x");
    room.click("boresight now");
    EXPECT_NE(room.said().words.find("forward"), std::string::npos);
    room.click("save");
    EXPECT_FALSE(room.draft().changed());
  }
}

TEST(Pages, TakeTheInstrumentForWhatTouches) {
  const TemporaryFile poses("instrument.csv");
  PagesRoom room(
      "[tracker]\naddress = \"" + going_away(poses.path) + "\"\n[tracker.stations]\ninstrument.station = 2\n",
      1);
  room.click("Tracker");
  room.click("Instrument's tip");
  room.click("begin");
  EXPECT_EQ(room.said().words, "Step 1 of 2") << "the right hand has no receiver";
  room.until([&] { return room.said().words == "Step 2 of 2"; });
  EXPECT_EQ(room.said().words, "Step 2 of 2") << "the second receiver rests";
}

TEST(Pages, TellWhereATabletIs) {
  const TemporaryFile poses("tablet.csv");
  PagesRoom room("[tracker]\naddress = \"" + going_away(poses.path) +
                     "\"\n[tracker.stations]\nright.station = 1\ntablet.station = 2\n",
                 1);
  room.click("Tracker");
  room.until([&] { return room.find("receiver 2 accurate") != nullptr; });
  EXPECT_NE(room.find("receiver 2 accurate"), nullptr);
}

TEST(Pages, ShowTheHandThatAGloveMakesAndItsGestures) {
  const TemporaryFile bends("bends.csv");
  std::string rows = "time,thumb,index,middle,ring,little,gesture\n";
  for (int k = 0; k <= 100; ++k) {
    const double bent = k < 50 ? 0.02 * k : 0.02 * (100 - k);
    rows += fmt::format("{:.2f},{:.2f},{:.2f},{:.2f},{:.2f},{:.2f},{}\n", 0.01 * k, 0.7 * bent, 0.2 * bent,
                        bent, bent, bent,
                        k > 40 && k < 60 ? "point"
                        : k < 10         ? "flat"
                                         : "none");
  }
  write_file(bends.path, rows);
  for (const double scale : {1., 2.}) {
    PagesRoom room("[glove.right]\naddress = \"recorded-loop:" + bends.path.string() + "\"\n", scale, scale);
    room.click("Glove");
    room.until([&] { return room.find("point made") != nullptr && room.find("flat made") != nullptr; });
    EXPECT_NE(room.find("point made"), nullptr);
    EXPECT_NE(room.find("flat made"), nullptr);
    EXPECT_NE(room.find("fist not made"), nullptr);
    EXPECT_NE(room.find("hand"), nullptr);
    room.picture(scale == 1 ? "glove-1x" : "glove-2x");
    room.click("left hand's");
    EXPECT_EQ(room.find("hand"), nullptr) << "there is no such glove";
  }
}

/// Writes a receiver that is put onto a grid's points, to and fro as the window asks, in a field that is bent
/// on the right.
void write_grid_walk(const std::filesystem::path& file) {
  std::string rows = "time,station,x,y,z,qw,qx,qy,qz\n";
  double time = 0;
  Vec3 at(-0.6, 0.8, -0.6);
  const auto tell = [&](const Vec3& p) {
    rows += fmt::format("{:.4f},1,{:.5f},{:.5f},{:.5f},1,0,0,0\n", time, p.x(), p.y(), p.z());
    time += 0.01;
  };
  const auto visit = [&](const Vec3& truth) {
    const double bent = 0.02 * std::exp(4 * (truth.x() - 0.4));
    const Vec3 to = truth + bent * Vec3(1, 0.5 * truth.z(), 0.3);
    for (int k = 1; k <= 8; ++k) tell(at + k / 8. * (to - at));
    for (int k = 0; k < 36; ++k) tell(to);
    at = to;
  };
  for (int k = 0; k < 100; ++k) tell(at);
  int row = 0;
  for (int y = 0; y < 3; ++y)
    for (int zz = 0; zz < 3; ++zz, ++row)
      for (int xx = 0; xx < 3; ++xx) {
        const int z = y % 2 == 0 ? zz : 2 - zz, x = row % 2 == 0 ? xx : 2 - xx;
        visit({-0.4 + 0.4 * x, 0.9 + 0.3 * y, -0.4 + 0.4 * z});
      }
  write_file(file, rows);
}

TEST(Pages, LeadThroughABentFieldAndShowIt) {
  const TemporaryFile walk("walk.csv");
  write_grid_walk(walk.path);
  PagesRoom room("[tracker]\naddress = \"recorded:" + walk.path.string() + "\"\n", 1);
  room.click("Tracker");
  room.click("Field distortion");
  const PlacedControl points = room.control("grid points");
  for (const double x : {55., 165., 275.}) {
    room.press(points.left + x, (points.top + points.bottom) / 2);
    room.type("3");
  }
  room.click("begin");
  EXPECT_EQ(room.said().words, "Step 1 of 27");
  room.until([&] { return room.find("once more") != nullptr; });
  EXPECT_EQ(room.said().words, "Done.");
  ASSERT_NE(room.find("field picture"), nullptr);
  room.picture("field");
  EXPECT_LT(room.control("save").bottom, room.height() - 40) << "it is seen without a wheel";
  EXPECT_EQ(room.draft().changes().back().after, "field_map = \"field.toml\"");
  EXPECT_GT(load_field_map(room.draft().file().parent_path() / "field.toml").before, 3e-3);
}

/// Writes a tip that touches a phantom's points as the page proposes them, where the phantom stands.
void write_touches(const std::filesystem::path& file, const Pose& room_phantom) {
  std::string rows = "time,station,x,y,z,qw,qx,qy,qz\n";
  double time = 0;
  Vec3 at(0.3, 1.3, 0.3);
  const auto tell = [&](const Vec3& p) {
    rows += fmt::format("{:.4f},1,{:.5f},{:.5f},{:.5f},1,0,0,0\n", time, p.x(), p.y(), p.z());
    time += 0.01;
  };
  for (int k = 0; k < 100; ++k) tell(at);
  for (const Vec3& point :
       {Vec3(-0.1, 0, 0.1), Vec3(0.1, 0, 0.1), Vec3(0.1, 0, -0.1), Vec3(-0.1, 0, -0.1), Vec3(0, 0.15, 0)}) {
    const Vec3 to = room_phantom * point;
    for (int k = 1; k <= 20; ++k) tell(at + k / 20. * (to - at));
    for (int k = 0; k < 70; ++k) tell(to);
    at = to;
  }
  write_file(file, rows);
}

TEST(Pages, LeadRoundAPhantomAndTellItsTargetsError) {
  const TemporaryFile touches("touches.csv");
  const Pose truth = {{0.1, 0.95, -0.1}, Quat(Eigen::AngleAxisd(0.4, Vec3(0.2, 1, 0).normalized()))};
  write_touches(touches.path, truth);
  PagesRoom room("[tracker]\naddress = \"recorded:" + touches.path.string() + "\"\n", 1);
  room.click("Tracker");
  room.click("Phantom");
  room.picture("phantom-wishes");
  EXPECT_LT(room.control("begin").bottom, room.height() - 40) << "it is seen without a wheel";
  room.click("begin");
  EXPECT_NE(room.said().words.find("body or mesh"), std::string::npos) << room.said().words;
  room.type("phantom.body", "skull");
  room.type("phantom.mesh", "skull.stl");
  room.click("begin");
  EXPECT_NE(room.said().words.find("not both"), std::string::npos) << room.said().words;
  EXPECT_FALSE(room.draft().changed());
  room.type("phantom.body", "");
  room.click("begin");
  EXPECT_EQ(room.said().words, "Step 1 of 5");
  room.picture("phantom-step");
  room.until([&] { return room.find("once more") != nullptr; });
  EXPECT_EQ(room.said().words, "Done.");
  EXPECT_LT(room.reported("expected error at 0.000, 0.000, 0.000 m: "), 0.1) << "mm";
  room.picture("phantom-done");
  const PhantomSettings& found = room.draft().config().phantom;
  ASSERT_TRUE(found.pose);
  EXPECT_LT((found.pose->p - truth.p).norm(), 1e-4) << "m";
  EXPECT_LT(found.pose->q.angularDistance(truth.q), 1e-3);
  room.click("save");
  EXPECT_NE(read_file(room.draft().file()).find("mesh = \"skull.stl\""), std::string::npos);
}

// What was measured stands beside its name from then on.
TEST(Pages, MeasureNoiseAndLatency) {
  const TemporaryFile poses("uneven.csv");
  std::string rows = "time,station,x,y,z,qw,qx,qy,qz\n";
  std::mt19937_64 random(4);
  std::normal_distribution<double> noise(0, 0.5e-3);
  for (int k = 0; k <= 1500; ++k) {
    const double t = 0.008 * k;
    rows +=
        fmt::format("{:.3f},1,{:.5f},0.1,0.2,1,0,0,0\n", t, 0.2 * std::sin(3 * t) + 0.1 * std::sin(7.3 * t));
    rows += fmt::format("{:.3f},2,{:.5f},{:.5f},{:.5f},1,0,0,0\n", t, noise(random), noise(random),
                        noise(random));
  }
  write_file(poses.path, rows);
  const std::string address = "recorded-loop:" + poses.path.string();
  PagesRoom room(
      "[tracker]\naddress = \"" + address + "\"\n[tracker.stations]\nright.station = 1\nhead.station = 2\n",
      1);
  const auto measure = [&](const char* what) {
    room.click("begin");
    room.until([&] { return room.find("once more") != nullptr; });
    EXPECT_EQ(room.said().words, "Done.") << what;
  };
  room.click("Tracker");
  room.click("Noise");
  room.click("role");
  room.click("head");
  room.type("seconds", "2");
  measure("noise");
  EXPECT_NEAR(room.reported("noise "), 0.866, 0.15) << "of three axes together";
  room.click("Latency");
  room.click("role");
  room.click("right hand");
  room.click("begin");
  EXPECT_TRUE(room.said().wrong) << "there is nothing to compare with";
  room.type("seconds", "4");
  room.type("against", address);
  measure("latency");
  EXPECT_LT(std::abs(room.reported("the measured device is ")), 20)
      << "both were opened at the same time, ms";
  room.picture("measured");
}

TEST(ObservedRanges, AreBetweenTheLeastAndTheMost) {
  ObservedRanges spans;
  const GloveCalibration calibration = {{100, 100, 600, 100, 100}, {600, 600, 100, 600, 600}};
  EXPECT_EQ(spans.share(0, std::nullopt), 1);
  spans.take({200, 100, 300, 50, 590});
  spans.take({450, 600, 500, 700, 600});
  const std::array<double, fingers> span = {250, 500, 200, 650, 10}, share = {0.5, 1, 0.4, 1, 0.02};
  for (std::size_t f = 0; f < fingers; ++f) {
    EXPECT_EQ(spans.span(f), span[f]);
    EXPECT_NEAR(spans.share(f, calibration), share[f], 1e-12);
  }
}

}  // namespace
}  // namespace prosector::test
