// Everyone who sees two servers of one session agrees which of them hosts it.

#include "common/server_run.h"

#include <gtest/gtest.h>

namespace prosector {
namespace {

using namespace std::chrono_literals;

TEST(ServerRun, TheLaterReignPrecedesThenWhoStartedEarlier) {
  const std::chrono::system_clock::time_point noon{std::chrono::hours(500000)};
  const auto first = make_server_run(1, noon, 7), later = make_server_run(1, noon + 1s, 3);
  const auto resumed = make_server_run(2, noon + 60s, 9);
  EXPECT_TRUE(precedes(first, later));
  EXPECT_FALSE(precedes(later, first));
  EXPECT_TRUE(precedes(resumed, first));
  EXPECT_FALSE(precedes(first, resumed));
  EXPECT_FALSE(precedes(first, first));
}

TEST(ServerRun, WhoStartedAtTheSameMomentIsDrawnByLot) {
  const std::chrono::system_clock::time_point noon{std::chrono::hours(500000)};
  const auto a = make_server_run(1, noon, 7), b = make_server_run(1, noon + 20ms, 8);
  EXPECT_NE(precedes(a, b), precedes(b, a));
  EXPECT_NE(make_server_run(1), make_server_run(1));
}

TEST(ServerRun, AReignBeyondTheLastIsTheLast) {
  const std::chrono::system_clock::time_point noon{std::chrono::hours(500000)};
  EXPECT_EQ(make_server_run(last_reign + 1, noon, 7), make_server_run(last_reign, noon, 7));
  EXPECT_TRUE(precedes(make_server_run(last_reign + 1, noon, 7), make_server_run(1, noon, 7)));
}

}  // namespace
}  // namespace prosector
