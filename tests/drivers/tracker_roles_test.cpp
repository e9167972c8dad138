// Which station has which role, where a tracker's driver knows some by itself, and what sees a role.
#include "drivers/config/tracker_roles.h"

#include <gtest/gtest.h>

namespace prosector {
namespace {

/// Stations as somebody wrote them who had an instrument first.
ClientConfig written_for(const std::string& tracker) {
  return parse_client_config("[tracker]\naddress = \"" + tracker +
                                 "\"\n[tracker.stations]\n"
                                 "instrument.station = 1\ninstrument.mount.position = [0, 0, -0.12]\n"
                                 "instrument.board = \"wrist-left\"\n"
                                 "right.station = 2\nright.mount.position = [0, 0.01, 0]\n"
                                 "tablet.station = 4\n",
                             "c.toml");
}

TEST(SettledRoles, OfBareHandsAreTheHandsAndThenTheOthers) {
  ClientConfig config = written_for("hands:0");
  apply_driver_roles(config);
  EXPECT_EQ(config.stations, (std::array{StationRole::right_hand, StationRole::left_hand,
                                         StationRole::instrument, StationRole::tablet}));
  const DeviceConfig& device = config.tracker_device;
  EXPECT_EQ(device.tags.boards, (std::array<std::string, max_stations>{"", "", "wrist-left", "tablet"}));
  EXPECT_EQ(device.placement.mount[0].p, Vec3(0, 0.01, 0)) << "the right hand's, and not the instrument's";
  EXPECT_TRUE(device.placement.mount[1].p.isZero());
  EXPECT_EQ(device.placement.mount[2].p, Vec3(0, 0, -0.12));
  EXPECT_EQ(device.placement.stations, 15u);
}

TEST(SettledRoles, StayAsWrittenWhereTheDriverKnowsNone) {
  ClientConfig config = written_for("tags:0");
  const ClientConfig before = config;
  apply_driver_roles(config);
  EXPECT_EQ(config.stations, before.stations);
  EXPECT_EQ(config.tracker_device.tags.boards, before.tracker_device.tags.boards);
}

TEST(SettledRoles, OfAFaceAreTheHead) {
  ClientConfig config = written_for("face:0");
  apply_driver_roles(config);
  EXPECT_EQ(config.stations[0], StationRole::head);
  EXPECT_EQ(config.stations[1], StationRole::none);
}

TEST(SeenFor, BoardsBesideBareHandsAreSeenByTags) {
  for (const char* hands : {"hands:0", "hands:0,2"}) {
    const ClientConfig tool = config_for_role(written_for(hands), StationRole::instrument);
    EXPECT_EQ(tool.tracker, "tags:0");
    EXPECT_EQ(tool.stations[0], StationRole::instrument) << "where it was written";
    EXPECT_EQ(tool.tracker_device.tags.boards[0], "wrist-left");
    EXPECT_EQ(tool.tracker_device.placement.mount[0].p, Vec3(0, 0, -0.12));
    const ClientConfig hand = config_for_role(written_for(hands), StationRole::right_hand);
    EXPECT_EQ(hand.tracker, hands);
    EXPECT_EQ(hand.stations[0], StationRole::right_hand);
  }
}

TEST(SeenFor, OtherTrackersSeeAllRolesThemselves) {
  for (const char* tracker : {"tags:0", "fastrak:/dev/ttyS0", "leap:localhost:6437"})
    EXPECT_EQ(config_for_role(written_for(tracker), StationRole::instrument).tracker, tracker);
  EXPECT_EQ(config_for_role(ClientConfig(), StationRole::instrument).tracker, "");
  EXPECT_EQ(board_tracker_address("hands:/dev/video2"), "tags:/dev/video2");
}

}  // namespace
}  // namespace prosector
