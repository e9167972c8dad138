#include "drivers/config/client_config.h"

#include <gtest/gtest.h>

#include "common/error.h"
#include "drivers/device/driver_table.h"
#include "tests/folders.h"

namespace prosector {
namespace {

TEST(ClientConfig, TheSampleSaysTheDefaults) {
  const ClientConfig sample = load_client_config(source_path("deploy/client.toml"));
  const ClientConfig defaults;
  EXPECT_EQ(sample.tracker, "fastrak:/dev/ttyS0");
  EXPECT_EQ(sample.tracker_device.fastrak.binary, defaults.tracker_device.fastrak.binary);
  EXPECT_EQ(sample.tracker_device.fastrak.hemisphere, defaults.tracker_device.fastrak.hemisphere);
  EXPECT_EQ(sample.tracker_device.placement.stations, defaults.tracker_device.placement.stations);
  EXPECT_EQ(sample.stations, defaults.stations);
  EXPECT_EQ(sample.gestures, defaults.gestures);
  const DeviceConfig &a = sample.gloves[right_hand].device, &b = defaults.gloves[right_hand].device;
  EXPECT_EQ(a.gestures.closed_above, b.gestures.closed_above);
  EXPECT_EQ(a.gestures.open_below, b.gestures.open_below);
  EXPECT_EQ(a.gestures.hysteresis, b.gestures.hysteresis);
}

TEST(ClientConfig, ReadsStationsAndRoom) {
  const ClientConfig config = parse_client_config(
      "[tracker]\naddress = 'fastrak:/dev/x'\nroom.position = [0, 1, 2]\n"
      "[tracker.stations]\nhead.station = 2\nleft.station = 4\nleft.mount.position = [0, 0, 1]\n",
      "c.toml");
  EXPECT_EQ(config.tracker_device.placement.stations, 10u);
  EXPECT_EQ(config.stations[1], StationRole::head);
  EXPECT_EQ(config.stations[3], StationRole::left_hand);
  EXPECT_EQ(config.tracker_device.placement.mount[3].p, Vec3(0, 0, 1));
  EXPECT_EQ(config.tracker_device.placement.room_device.p, Vec3(0, 1, 2));
}

TEST(ClientConfig, BadInputSaysWhereAndWhat) {
  struct Case {
    const char* toml;
    const char* says;
  };
  const Case cases[] = {
      {"x = 1", "c.toml:1: x: unknown key"},
      {"[tracker]\naddress = 'fastrack:/dev/x'", "c.toml:2: tracker.address"},
      {"[tracker]\naddress = 'fastrak:'", "path must follow"},
      {"[tracker]\naddress = 'fastrak:/x'\nhemisphere = [1, 2]", "c.toml:3: tracker.hemisphere"},
      {"[tracker]\naddress = 'fastrak:/x'\nalignment = [0,0,0,1,0,0,2,0,0]", "line"},
      {"[tracker]\naddress = 'fastrak:/x'\nroom.position = [nan, 0, 0]", "tracker.room.position"},
      {"[tracker]\naddress = 'fastrak:/x'\nroom.orientation = [0, 0, 0, 0]", "unit quaternion"},
      {"[tracker]\naddress = 'fastrak:/x'\nstations.head.station = 5", "from 0 to 4"},
      {"[tracker]\naddress = 'fastrak:/x'\nstations.head.station = 1\nstations.left.station = 1",
       "another role"},
      {"[glove.right]\naddress = '5dt:/x'\nclosed_above = 0.3", "must exceed open_below"},
      {"[glove.right]\naddress = '5dt:/x'\nopen = [1,2,3,4,5]", "together"},
      {"[glove.middle]\naddress = '5dt:/x'", "allowed here: left, right"},
      {"[gestures]\nfist = 'explode'", "must be none, grasp, release, reset, panel or parts"},
      {"[gestures]\nwave = 'grasp'", "unknown key"},
      {"[phantom]\nbody = 'skull'\nmesh = 'skull.stl'",
       "c.toml:3: phantom.mesh: give body or mesh, not both"},
      {"[phantom]\nboard = 'table'", "c.toml:2: phantom.board: also give body or mesh"},
      {"[phantom]\nposition = [0, 0, 0]", "c.toml:2: phantom.position: also give body or mesh"},
      {"[phantom]\nbody = 'skull'\nscale = 0", "phantom.scale: must be a number from"},
      {"[tracker", "c.toml:1"},
  };
  for (const Case& c : cases) {
    try {
      parse_client_config(c.toml, "c.toml");
      ADD_FAILURE() << "accepted: " << c.toml;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(c.says), std::string::npos) << e.what();
    }
  }
}

TEST(OpenDevice, UnknownDriversListTheKnown) {
  try {
    open_device("mouse:/dev/x", {});
    FAIL();
  } catch (const InputError& e) {
    for (const DriverRow& row : drivers()) EXPECT_NE(std::string(e.what()).find(row.name), std::string::npos);
  }
}

}  // namespace
}  // namespace prosector
