// A real server whose processor is taken away: it says whom it solves less exactly, recovers, and its journal
// replays to the same hash.

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/dds_domains.h"
#include "tests/session/server_process.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;
using test::feed_until;

// Damped so much that it sinks through the empty room at 0.2 m/s for as long as anyone watches: awake, and
// each tick costs the same milliseconds, many more than a starved server gets at a time on any machine, and
// far fewer than its tick has.
const char* const scene_text = R"(
name = "sinking"
tick_rate = 10
[[soft]]
name = "jelly"
shape = "block"
size = [0.1, 0.1, 0.1]
cell = 0.025
surface_cell = 0.025
position = [0, 100, 0]
model = "xpbd"
substeps = 64
damping_mass = 50
step_down = true
)";

/// Lets the server run 1 ms in 150, or the little more that a busy machine makes of it: a tick that is
/// stopped once takes longer than its 100 ms.
class Starved {
 public:
  explicit Starved(const test::Server& server)
      : thread_([this, &server] {
          while (!over_) {
            server.signal(SIGSTOP);
            std::this_thread::sleep_for(149ms);
            server.signal(SIGCONT);
            std::this_thread::sleep_for(1ms);
          }
        }) {}
  ~Starved() {
    over_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> over_{false};
  std::thread thread_;
};

TEST(ServerProcess, StepsDownWhenStarvedSaysSoAndStepsUpAgain) {
  const test::Folder folder(test::dds_domain::overload);
  const std::string journal = folder.path / "journal", summary = folder.path / "summary.json";
  std::ofstream(folder.path / "sinking.toml") << scene_text;
  test::Server server(folder, {folder.path / "sinking.toml", "--journal", journal, "--summary", summary});
  ASSERT_TRUE(server.says("is open on this machine")) << server.output();
  const auto bus = test::join_network(folder, BusEnd::observer);
  Replica replica;
  const auto steps_down = [&] {
    const BodyStatus* told = replica.body_status(0);
    return told == nullptr ? -1 : static_cast<int>(told->stepped_down);
  };
  const auto status_names_it = [&] {
    return replica.status() &&
           replica.status()->degraded.find("jelly: effort reduced by") != std::string::npos;
  };
  ASSERT_TRUE(feed_until(
      *bus, replica, [&] { return steps_down() == 0; }, 30s))
      << server.output();
  {
    const Starved starved(server);
    EXPECT_TRUE(feed_until(
        *bus, replica, [&] { return steps_down() > 0 && status_names_it(); }, 60s))
        << server.output();
  }
  EXPECT_TRUE(feed_until(
      *bus, replica, [&] { return steps_down() == 0 && !status_names_it(); }, 60s))
      << server.output();
  EXPECT_TRUE(server.says("jelly: solver effort is reduced by 1 of 3 steps: the server is overloaded"));
  EXPECT_TRUE(server.says("jelly is solved at its configured effort again: the server has spare capacity"));

  server.signal(SIGTERM);
  EXPECT_EQ(server.wait(), 0);
  const std::string last_hash = nlohmann::json::parse(std::ifstream(summary))["state_hash"];
  test::Server replay(folder, {"--replay", journal});
  EXPECT_EQ(replay.wait(), 0);
  EXPECT_NE(replay.output().find(last_hash), std::string::npos) << replay.output();
}

}  // namespace
}  // namespace prosector
