// What clients, and the run's summary, are told of how far bodies are off.

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "server/session/run/summary.h"
#include "tests/session/hosted.h"
#include "tests/session/temporary_file.h"

namespace prosector {
namespace {

using test::Guest;
using test::Hosted;

TEST(ToldError, IsTheBodysOwnAsItIsNowAndThatOfAPressWhileItLasts) {
  Hosted hosted;
  Guest ada = hosted.guest(7, BusEnd::dissector);
  ada.greet("ada", Role::dissector);
  bool at_rest = false, pressed = false;
  for (std::uint64_t t = 0; t < 400; ++t) {
    if (t >= 60) ada.bus->publish(ada.hand_at(test::press(t - 60)));
    hosted.tick();
    ada.take();
    const BodyStatus* reported = ada.replica.body_status(Hosted::liver);
    if (reported == nullptr || reported->error < 0) continue;
    EXPECT_LT(reported->error, 10);
    EXPECT_GE(reported->parts.solver, 0);
    EXPECT_GE(reported->parts.time, 0);
    EXPECT_FALSE(reported->error_map.levels.empty());
    at_rest = at_rest || (reported->asleep && reported->press_error < 0 && reported->parts.time == 0);
    pressed = pressed || (!reported->asleep && reported->press_error > 0);
  }
  EXPECT_TRUE(at_rest);
  EXPECT_TRUE(pressed);
  std::this_thread::sleep_for(std::chrono::milliseconds(110));  // the status is told ten times a second
  hosted.tick();
  ada.take();
  ASSERT_TRUE(ada.replica.status());
  EXPECT_GE(ada.replica.status()->error, 0);
  const BodyStatus* reported = ada.replica.body_status(Hosted::liver);
  ASSERT_NE(reported, nullptr);
  EXPECT_LT(reported->press_error, 0) << "the hand left";

  const test::TemporaryFile file("summary");
  ASSERT_TRUE(write_summary(file.path, hosted.loop, hosted.simulation, ""));
  const nlohmann::json summary = nlohmann::json::parse(std::ifstream(file.path));
  EXPECT_GE(summary["error"]["liver"]["all"].get<double>(), 0);
  EXPECT_GT(summary["pressed"]["liver"]["force_n"].get<double>(), 0.01);
  EXPECT_GT(summary["pressed"]["liver"]["error"].get<double>(), 0);
}

}  // namespace
}  // namespace prosector
