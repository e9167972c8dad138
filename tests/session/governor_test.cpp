// Stepping down under overload: the decision by itself, then through a session, its journal and a replay.

#include "server/session/run/governor.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>

#include "common/error.h"
#include "server/session/journal/input_bytes.h"
#include "server/session/journal/replay.h"
#include "tests/session/hosted.h"

namespace prosector {
namespace {

using test::Guest;

constexpr double rate = 60, period = 1 / rate;

/// Feeds ticks of that many periods for so many seconds; returns the changes.
std::vector<EffortChange> feed(Governor& governor, double periods, double seconds,
                               const std::map<BodyId, double>& work = {{1, 5}, {2, 9}}) {
  std::vector<EffortChange> out;
  for (int i = 0; i < static_cast<int>(seconds * rate); ++i)
    if (const auto change = governor.tick(periods * period, work)) out.push_back(*change);
  return out;
}

TEST(Governor, StepsTheCostliestDownAndTheLastUpAgain) {
  Governor governor(rate, {{1, 0}, {2, 0}});
  auto down = feed(governor, 1.5, Governor::overload_seconds);
  ASSERT_EQ(down.size(), 1u);
  EXPECT_EQ(down[0].body, 2u);
  EXPECT_EQ(down[0].steps_down, 1);
  EXPECT_TRUE(feed(governor, 0.3, Governor::room_seconds - 2 * period).empty());
  const auto up = feed(governor, 0.3, 4 * period);
  ASSERT_EQ(up.size(), 1u);
  EXPECT_EQ(up[0].body, 2u);
  EXPECT_EQ(up[0].steps_down, 0);
  EXPECT_TRUE(feed(governor, 0.3, 60).empty()) << "nothing is left to step up";
}

TEST(Governor, GoesNoFurtherThanTheLastStep) {
  Governor governor(rate, {{1, 0}, {2, 0}});
  const auto changes = feed(governor, 3, 60);
  EXPECT_EQ(changes.size(), 2 * max_steps_down);
  for (const auto& [body, steps] : governor.steps_down()) EXPECT_EQ(steps, static_cast<int>(max_steps_down));
}

TEST(Governor, LeavesAloneWhoMayNotOrSleeps) {
  Governor nobody(rate, {});
  EXPECT_TRUE(feed(nobody, 3, 10).empty());
  Governor governor(rate, {{1, 0}});
  EXPECT_TRUE(feed(governor, 3, 10, {{1, 0}, {2, 9}}).empty());
}

TEST(Governor, HoldsBetweenLateAndRoomy) {
  Governor governor(rate, {{1, 0}});
  ASSERT_EQ(feed(governor, 1.5, Governor::overload_seconds).size(), 1u);
  // In time, but with less room than a step up may take: it stays where it is.
  EXPECT_TRUE(feed(governor, 0.8, 60).empty());
  // A late tick in ten is no overload, and no room either.
  for (int i = 0; i < 600; ++i)
    EXPECT_FALSE(governor.tick(i % 10 == 0 ? 2 * period : 0.3 * period, {{1, 5}}));
}

TEST(Governor, WaitsLongerAfterAStepUpInVain) {
  Governor governor(rate, {{1, 0}});
  // A body that fits only when stepped down: its ticks are late at 0 and have room at 1.
  int changes = 0, steps = 0;
  for (int i = 0; i < static_cast<int>(300 * rate); ++i)
    if (const auto change = governor.tick((steps == 0 ? 1.5 : 0.4) * period, {{1, 5}})) {
      steps = change->steps_down;
      ++changes;
    }
  // Without memory it would change every 2.5 s: 240 times.
  EXPECT_LT(changes, 30);
  EXPECT_GT(changes, 6);
}

TEST(Governor, StartsFromARestoredState) {
  Governor governor(rate, {{1, 2}});
  const auto up = feed(governor, 0.3, 3 * Governor::room_seconds);
  ASSERT_EQ(up.size(), 2u);
  EXPECT_EQ(up.back().steps_down, 0);
}

TEST(InputBytes, KeepEffortChanges) {
  ConsumedInput input;
  input.input.efforts = {{3, 2}, {70000, 0}};
  const auto bytes = encode_input(input);
  const ConsumedInput back = decode_input(bytes);
  ASSERT_EQ(back.input.efforts.size(), 2u);
  EXPECT_EQ(back.input.efforts[1].body, 70000u);
  EXPECT_EQ(back.input.efforts[0].steps_down, 2);
  auto spoiled = bytes;
  spoiled[4 + 4 + 4] = 200;  // keys, count, body of the first change, then its steps
  EXPECT_THROW(decode_input(spoiled), InputError);
}

/// A session whose clock says what a test tells it: each tick takes `periods`.
struct Governed {
  double periods = 0.2;
  std::int64_t now = 0;
  std::int64_t next() { return now += static_cast<std::int64_t>(periods * period * 1e9); }

  static SceneDesc scene() {
    SceneDesc scene = test::hosted_scene();
    scene.soft[0].choice.step_down = true;
    return scene;
  }
  LocalNetwork network{LocalNetworkConfig{}};
  Simulation simulation{scene(), test::options()};
  std::unique_ptr<Bus> bus = network.join(test::Hosted::config(BusEnd::server));
  std::vector<std::string> log;
  std::unique_ptr<ServerLoop> loop;

  explicit Governed(Journal* journal)
      : loop(std::make_unique<ServerLoop>(
            simulation, *bus, "prosector", journal, [this](const std::string& line) { log.push_back(line); },
            LoopOptions{.choices = {}, .clock = [this] { return next(); }})) {}
};

TEST(Governor, WhatItDecidesIsJournalledAndReplaysToTheSameHash) {
  const auto file = std::filesystem::temp_directory_path() / ("governed." + std::to_string(getpid()));
  std::filesystem::remove(file);
  std::uint64_t last = 0;
  int most_down = 0;
  {
    const auto journal = Journal::create(file, {"governed.toml", "", "prosector", {}, {}}, {});
    Governed governed(journal.get());
    Guest ada;
    ada.bus = governed.network.join(test::Hosted::config(BusEnd::dissector));
    ada.id = 1;
    const auto tick = [&] {
      governed.loop->tick();
      governed.loop->publisher().flush();
      governed.network.advance(std::chrono::microseconds(16667));
      ada.take();
    };
    tick();
    ada.greet("ada", Role::dissector);
    tick();
    for (std::uint64_t t = 0; t < 220; ++t) {
      governed.periods = t < 90 ? 1.5 : 0.2;  // overloaded at first
      ada.bus->publish(ada.hand_at(test::press(t % 80)));
      tick();
      const int down = governed.simulation.soft_state(test::Hosted::liver).steps_down;
      most_down = std::max(most_down, down);
      if (t == 100) {
        EXPECT_NE(governed.loop->status().degraded.find("liver: effort reduced by"), std::string::npos);
        ASSERT_NE(ada.replica.body_status(test::Hosted::liver), nullptr);
        EXPECT_GT(ada.replica.body_status(test::Hosted::liver)->stepped_down, 0u);
      }
    }
    EXPECT_GE(most_down, 2);
    EXPECT_LT(governed.simulation.soft_state(test::Hosted::liver).steps_down, most_down) << "steps up again";
    EXPECT_FALSE(governed.log.empty());
    last = governed.loop->figures().state_hash;
  }
  const JournalReader journal(file);
  int journalled = 0;
  Simulation again(Governed::scene(), test::options(2));
  Simulation deaf(Governed::scene(), test::options());  // takes all inputs but the changes of effort
  journal.for_each_tick(0, [&](const JournalTick& tick) {
    journalled += static_cast<int>(tick.input.input.efforts.size());
    again.step(tick.input.input);
    TickInput without = tick.input.input;
    without.efforts.clear();
    deaf.step(without);
    if (tick.rebuilt) again.checkpoint(), deaf.checkpoint();
    EXPECT_EQ(again.state_hash(), tick.state_hash) << "tick " << tick.tick;
    return again.state_hash() == tick.state_hash;
  });
  EXPECT_GE(journalled, 3);
  EXPECT_EQ(again.state_hash(), last);
  EXPECT_NE(deaf.state_hash(), last);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace prosector
