// The devices that the set-up window shows, and the configuration that it changes.
#include <gtest/gtest.h>

#include <thread>

#include "client/setup/config_draft.h"
#include "client/setup/device_watch.h"
#include "common/clock.h"
#include "common/error.h"
#include "drivers/config/found_devices.h"
#include "drivers/device/driver_table.h"
#include "tests/session/temporary_file.h"
#include "tests/setup/written_file.h"

namespace prosector::test {
namespace {

constexpr const char* own_config =
    "# mine\n[tracker]\naddress = \"recorded:/nowhere.csv\"  # on the "
    "shelf\n\n[tracker.stations]\nright.station = 1\n";

TEST(ConfigDraft, WritesNothingBeforeItIsAskedTo) {
  const TemporaryFile file("draft.toml");
  write_file(file.path, own_config);
  ConfigDraft draft(file.path);
  EXPECT_EQ(draft.problem(), "");
  EXPECT_FALSE(draft.changed());
  EXPECT_EQ(draft.change({{"tracker.stations.right.station", 3.}}), "");
  EXPECT_TRUE(draft.changed());
  EXPECT_EQ(draft.config().stations[2], StationRole::right_hand);
  EXPECT_EQ(read_file(file.path), own_config);
  const auto changes = draft.changes();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].before, "right.station = 1");
  EXPECT_EQ(changes[0].after, "right.station = 3");
  draft.save();
  EXPECT_FALSE(draft.changed());
  std::string expected = own_config;
  expected.replace(expected.find("right.station = 1"), 17, "right.station = 3");
  EXPECT_EQ(read_file(file.path), expected) << "comments and order stay";
}

TEST(ConfigDraft, RefusesInWordsAndKeepsWhatItHad) {
  const TemporaryFile file("draft.toml");
  write_file(file.path, own_config);
  ConfigDraft draft(file.path);
  EXPECT_NE(draft.change({{"tracker.stations.right.station", 9.}}).find("must be"), std::string::npos);
  EXPECT_NE(draft.change({{"tracker.address", std::string("nothing")}}).find("unknown driver"),
            std::string::npos);
  EXPECT_FALSE(draft.changed());
  EXPECT_EQ(draft.config().stations[0], StationRole::right_hand);
  EXPECT_EQ(draft.change({{"tracker.boresight", true}}), "");
  draft.revert();
  EXPECT_FALSE(draft.changed());
  EXPECT_FALSE(draft.config().tracker_device.fastrak.boresight);
}

TEST(ConfigDraft, TakesAReceiverOrADeviceAwayAndKeepsAllElse) {
  const TemporaryFile file("draft.toml");
  const std::string text =
      "[tracker]\naddress = \"fastrak:/x\"  # ours\n[tracker.stations]\nright.station = 1  # the glove's\n"
      "right.mount.position = [0, 0.1, 0]\nhead.station = 2\n[glove.right]\naddress = \"5dt:/y\"\npinch = "
      "true\n";
  write_file(file.path, text);
  ConfigDraft draft(file.path);
  EXPECT_EQ(draft.change({{"tracker.stations.right.station", 0.}}), "");
  EXPECT_EQ(draft.config().stations[0], StationRole::none);
  EXPECT_EQ(draft.config().stations[1], StationRole::head);
  EXPECT_EQ(draft.config().tracker_device.placement.stations, 2u);
  EXPECT_EQ(draft.change({{"glove.right.address", std::string()}}), "");
  EXPECT_EQ(draft.config().gloves[right_hand].address, "");
  EXPECT_TRUE(draft.config().gloves[right_hand].device.gestures.pinch);
  EXPECT_NE(draft.change({{"tracker.stations.head.station", 0.}}).find("at least one"), std::string::npos);
  draft.save();
  std::string expected = text;
  expected.replace(expected.find("right.station = 1"), 17, "right.station = 0");
  expected.replace(expected.find("\"5dt:/y\""), 8, "\"\"");
  EXPECT_EQ(read_file(file.path), expected) << "comments, order and mounts stay";
  EXPECT_EQ(draft.change({{"tracker.stations.right.station", 3.}}), "");
  EXPECT_EQ(draft.config().tracker_device.placement.mount[2].p, Vec3(0, 0.1, 0)) << "its mount goes with it";
}

TEST(ConfigDraft, OfAFileThatIsMissingOneIsMade) {
  const TemporaryFile file("draft.toml");
  ConfigDraft draft(file.path);
  EXPECT_EQ(draft.change({{"glove.right.address", std::string("5dt:/dev/ttyS1")}}), "");
  draft.save();
  EXPECT_EQ(ConfigDraft(file.path).config().gloves[right_hand].address, "5dt:/dev/ttyS1");
}

TEST(ConfigDraft, WhatOthersWroteMeanwhileIsNotWrittenOver) {
  const TemporaryFile file("draft.toml");
  write_file(file.path, own_config);
  ConfigDraft draft(file.path);
  EXPECT_EQ(draft.change({{"tracker.boresight", true}}), "");
  const std::string theirs = std::string(own_config) + "[eyes]\ndistance = 0.06\n";
  write_file(file.path, theirs);
  EXPECT_THROW(draft.save(), InputError);
  EXPECT_EQ(read_file(file.path), theirs);
  draft.revert();
  EXPECT_EQ(draft.config().eyes.distance, 0.06);
  EXPECT_EQ(draft.change({{"tracker.boresight", true}}), "");
  draft.save();
  EXPECT_NE(read_file(file.path).find("distance = 0.06"), std::string::npos);
  EXPECT_NE(read_file(file.path).find("boresight = true"), std::string::npos);
}

TEST(ConfigDraft, OfADamagedFileItSaysWhyAndTouchesNothing) {
  const TemporaryFile file("draft.toml");
  write_file(file.path, "[tracker]\nwings = 2\n");
  ConfigDraft draft(file.path);
  EXPECT_NE(draft.problem().find(":2: "), std::string::npos) << draft.problem();
  EXPECT_EQ(draft.change({{"tracker.boresight", true}}), draft.problem());
  EXPECT_FALSE(draft.changed());
}

/// A tracker of two receivers, of which the second one goes back and forth.
WatchedDevice watched(double second, double first = 0.01) {
  WatchedDevice out;
  out.stations.resize(2);
  out.stations[0].moved = first;
  out.stations[1].last.station = 1;
  out.stations[1].moved = second;
  return out;
}

TEST(MovingStation, IsWhatMovesMuchFartherThanTheOthers) {
  EXPECT_EQ(moving_station(watched(0.4)), 1u);
  EXPECT_EQ(moving_station(watched(0.02, 0.5)), 0u);
  EXPECT_FALSE(moving_station(watched(0.4, 0.2)));
  EXPECT_FALSE(moving_station(watched(0.1)));
  EXPECT_FALSE(moving_station(WatchedDevice{}));
}

TEST(DeviceWatch, TellsWhatADeviceTells) {
  const TemporaryFile hand("hand.csv");
  std::string rows = "time,station,x,y,z,qw,qx,qy,qz\n";
  for (int k = 0; k <= 100; ++k) {
    rows += std::to_string(0.01 * k) + ",1,0,1,0,1,0,0,0\n";
    rows += std::to_string(0.01 * k) + ",2," + std::to_string(0.004 * k) + ",1,0,1,0,0,0\n";
  }
  write_file(hand.path, rows);
  ClientConfig config;
  config.tracker = "recorded:" + hand.path.string();
  DeviceWatch watch(config);
  ASSERT_EQ(watch.devices().size(), 1u);
  for (int k = 0; k < 130; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    watch.poll(monotonic_ns());
  }
  const WatchedDevice& tracker = watch.devices()[0];
  EXPECT_EQ(tracker.name, "tracker");
  ASSERT_EQ(tracker.stations.size(), 2u);
  EXPECT_NEAR(tracker.stations[1].moved, 0.4, 0.05);
  EXPECT_LT(tracker.stations[0].moved, 1e-9);
  EXPECT_GT(tracker.stations[1].rate, 50);
  EXPECT_EQ(moving_station(tracker), 1u);
}

TEST(DeviceWatch, WhatIsNotThereIsSaid) {
  ClientConfig config;
  config.gloves[left_hand].address = "5dt:/nowhere";
  DeviceWatch watch(config);
  watch.poll(monotonic_ns());
  ASSERT_EQ(watch.devices().size(), 1u);
  EXPECT_EQ(watch.devices()[0].name, "left glove");
  EXPECT_EQ(watch.devices()[0].status.health, DeviceHealth::absent);
  EXPECT_NE(watch.devices()[0].status.message.find("/nowhere"), std::string::npos);
}

TEST(DeviceWatch, AFileThatCannotBeReadIsSaid) {
  ClientConfig config;
  config.tracker = "recorded:/nowhere.csv";
  DeviceWatch watch(config);
  watch.poll(monotonic_ns());
  ASSERT_EQ(watch.devices().size(), 1u);
  EXPECT_EQ(watch.devices()[0].status.health, DeviceHealth::absent);
  EXPECT_NE(watch.devices()[0].status.message.find("/nowhere.csv"), std::string::npos);
}

TEST(FoundDevices, ArePortsThatAreThereAndGloves) {
  const TemporaryFile root("found");
  const std::filesystem::path sys = root.path / "sys/class";
  write_file(sys / "tty/ttyS0/port", "0x3F8\n");
  write_file(sys / "tty/ttyS1/port", "0x0\n");
  write_file(sys / "tty/ttyUSB0/device/uevent", "DRIVER=ftdi_sio\n");
  write_file(sys / "tty/tty1/dev", "4:1\n");
  write_file(sys / "hidraw/hidraw0/device/uevent", "HID_ID=0003:0000046D:0000C077\nHID_NAME=Mouse\n");
  write_file(sys / "hidraw/hidraw1/device/uevent", "HID_ID=0003:00005D70:00000001\nHID_NAME=5DT Glove\n");
  const std::vector<FoundDevice> found = found_devices(root.path);
  std::filesystem::remove_all(root.path);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].addresses[0], "fastrak:/dev/ttyS0");
  EXPECT_EQ(found[1].name, "ttyUSB0: ftdi_sio");
  EXPECT_EQ(found[2].name, "hidraw1: 5DT Glove");
  EXPECT_EQ(found[2].addresses[0], "5dt-usb:/dev/hidraw1");
  for (const FoundDevice& device : found)
    for (const std::string& address : device.addresses) EXPECT_NO_THROW((void)parse_device_address(address));
}

TEST(FoundDevices, CamerasAreListedOnceEach) {
  const TemporaryFile root("found_cameras");
  const std::filesystem::path sys = root.path / "sys/class/video4linux";
  write_file(sys / "video0/name", "HD Webcam\n");
  write_file(sys / "video0/index", "0\n");
  write_file(sys / "video1/name", "HD Webcam\n");
  write_file(sys / "video1/index", "1\n");
  const std::vector<FoundDevice> found = found_cameras(root.path);
  std::filesystem::remove_all(root.path);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "video0: HD Webcam");
  EXPECT_EQ(found[0].addresses, std::vector<std::string>{"/dev/video0"});
}

}  // namespace
}  // namespace prosector::test
