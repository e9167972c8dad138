// The driver of Haply's Inverse3 at a real WebSocket of its twin, with the faults that real lines have.
#include <gtest/gtest.h>

#include "common/clock.h"
#include "drivers/arms/inverse3.h"
#include "tests/haptics/arm_line_case.h"
#include "twins/arms/inverse3_server.h"

namespace prosector {
namespace {

/// A twin at its socket, served by a thread a thousand times a second.
class ServedTwin {
 public:
  explicit ServedTwin(std::uint16_t port = 0) : server_(twin_, port) {}

  std::string path() const { return "localhost:" + std::to_string(server_.port()); }
  std::uint16_t port() const { return server_.port(); }

  std::atomic<bool> mute = false, cut = false;
  std::atomic<double> garbage = 0, force = 0;  // N: what its motors do

 private:
  Inverse3Twin twin_{{pressing_hand(), 1, 0}, monotonic_ns()};
  Inverse3Server server_;
  EachMillisecond thread_{[this] {
    server_.mute = mute;
    twin_.garbage = garbage;
    if (cut.exchange(false)) server_.cut();
    server_.serve();
    twin_.advance(monotonic_ns());
    force = twin_.arm().model().force().norm();
  }};
};

TEST(Inverse3Line, ConnectsFeelsAndLeavesNoForce) {
  ServedTwin twin;
  {
    const auto arm = open_inverse3(twin.path(), {});
    ASSERT_TRUE(comes(*arm, valid)) << arm->status().message;
    EXPECT_TRUE(comes(*arm, [&](const ArmReading&) { return twin.force > 0.99; }));
    EXPECT_EQ(arm->status().health, DeviceHealth::streaming);
    arm->set_force(Vec3::Zero());
  }
  EXPECT_TRUE(comes_true([&] { return twin.force == 0; }));
}

TEST(Inverse3Line, ALineThatBreaksComesBackByItself) {
  ServedTwin twin;
  const auto arm = open_inverse3(twin.path(), {});
  ASSERT_TRUE(comes(*arm, valid)) << arm->status().message;
  twin.cut = true;
  ASSERT_TRUE(comes(*arm, [](const ArmReading& r) { return !r.valid; }));
  ASSERT_TRUE(comes(*arm, [&](const ArmReading& r) { return r.valid && arm->status().reopens == 1; }));
}

TEST(Inverse3Line, SilenceIsSaidAndTriedAnew) {
  ServedTwin twin;
  const auto arm = open_inverse3(twin.path(), {});
  ASSERT_TRUE(comes(*arm, valid)) << arm->status().message;
  twin.mute = true;
  ASSERT_TRUE(comes(*arm, [&](const ArmReading& r) {
    return !r.valid && arm->status().message.find("no more data") != std::string::npos;
  })) << arm->status().message;
  twin.mute = false;
  EXPECT_TRUE(comes(*arm, valid)) << arm->status().message;
}

TEST(Inverse3Line, BrokenTextsAreSaidAndBorne) {
  ServedTwin twin;
  const auto arm = open_inverse3(twin.path(), {});
  ASSERT_TRUE(comes(*arm, valid)) << arm->status().message;
  twin.garbage = 1;
  ASSERT_TRUE(comes(*arm, [&](const ArmReading& r) {
    return !r.valid && (arm->status().health == DeviceHealth::babbling || !arm->status().message.empty());
  }));
  twin.garbage = 0;
  EXPECT_TRUE(comes(*arm, valid)) << arm->status().message;
}

TEST(Inverse3Line, NobodyThereIsSaidUntilSomebodyComes) {
  std::uint16_t port = 0;
  { port = ServedTwin().port(); }
  const auto arm = open_inverse3("localhost:" + std::to_string(port), {});
  ASSERT_TRUE(comes(
      *arm, [&](const ArmReading& r) { return !r.valid && arm->status().health == DeviceHealth::absent; }));
  EXPECT_NE(arm->status().message.find("localhost:" + std::to_string(port)), std::string::npos)
      << arm->status().message;
  ServedTwin twin(port);
  EXPECT_TRUE(comes(*arm, valid)) << arm->status().message;
}

}  // namespace
}  // namespace prosector
