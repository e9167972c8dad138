// The driver of an arm at a VRPN server, at a real TCP port of its twin.
#include <gtest/gtest.h>

#include "common/clock.h"
#include "drivers/arms/vrpn_arm.h"
#include "tests/haptics/arm_line_case.h"
#include "twins/arms/vrpn_server.h"

namespace prosector {
namespace {

/// A VRPN server, served by a thread a thousand times a second.
class ServedVrpn {
 public:
  explicit ServedVrpn(std::uint16_t port = 0) : server_(twin_, port) {}

  std::string path() const { return "Arm0@localhost:" + std::to_string(server_.port()); }
  std::uint16_t port() const { return server_.port(); }

  std::atomic<bool> cut = false;
  std::atomic<double> force = 0;  // N: what its motors do

 private:
  VrpnTwin twin_{{pressing_hand(), "Arm0", 1, 0}, monotonic_ns()};
  VrpnServer server_;
  EachMillisecond thread_{[this] {
    if (cut.exchange(false)) server_.cut();
    server_.serve(monotonic_ns());
    force = twin_.arm().model().force().norm();
  }};
};

TEST(VrpnLine, ConnectsFeelsAndLeavesNoForce) {
  ServedVrpn twin;
  {
    const auto arm = open_vrpn(twin.path(), {});
    ASSERT_TRUE(comes(*arm, valid)) << arm->status().message;
    EXPECT_TRUE(comes(*arm, [&](const ArmReading&) { return twin.force > 0.99; }));
    EXPECT_EQ(arm->status().health, DeviceHealth::streaming);
  }
  EXPECT_TRUE(comes_true([&] { return twin.force == 0; }));
}

TEST(VrpnLine, ALineThatBreaksComesBackByItself) {
  ServedVrpn twin;
  const auto arm = open_vrpn(twin.path(), {});
  ASSERT_TRUE(comes(*arm, valid)) << arm->status().message;
  twin.cut = true;
  ASSERT_TRUE(comes(*arm, [](const ArmReading& r) { return !r.valid; }));
  ASSERT_TRUE(comes(*arm, [&](const ArmReading& r) { return r.valid && arm->status().reopens == 1; }));
}

TEST(VrpnLine, NobodyThereIsSaidUntilSomebodyComes) {
  std::uint16_t port = 0;
  { port = ServedVrpn().port(); }
  const auto arm = open_vrpn("Arm0@localhost:" + std::to_string(port), {});
  ASSERT_TRUE(comes(
      *arm, [&](const ArmReading& r) { return !r.valid && arm->status().health == DeviceHealth::absent; }));
  EXPECT_NE(arm->status().message.find("localhost:" + std::to_string(port)), std::string::npos)
      << arm->status().message;
  ServedVrpn twin(port);
  EXPECT_TRUE(comes(*arm, valid)) << arm->status().message;
}

}  // namespace
}  // namespace prosector
