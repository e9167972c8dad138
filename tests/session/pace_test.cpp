// The host's hand on time: who may, what goes on while time is stopped, and that nothing else changes.

#include <gtest/gtest.h>

#include "server/session/run/tick_schedule.h"
#include "tests/session/hosted.h"

namespace prosector {
namespace {

using test::Guest;
using test::Hosted;

/// A host and a dissector in a session that turns.
class HandOnTime : public testing::Test {
 protected:
  Hosted hosted;
  Guest ada = hosted.guest(1, BusEnd::dissector), bo = hosted.guest(2, BusEnd::dissector);

  void SetUp() override {
    turn(1);
    ada.greet("ada", Role::host);
    bo.greet("bo", Role::dissector);
    turn(3);
  }
  void turn(int times) {
    for (int i = 0; i < times; ++i) {
      hosted.loop.turn();
      hosted.loop.publisher().flush();
      hosted.network.advance(std::chrono::microseconds(16667));
      ada.take();
      bo.take();
    }
  }
  std::uint64_t tick() const { return hosted.simulation.time().tick; }
  /// Asks, turns once, and returns the answer.
  CommandResult ask(Guest& guest, const CommandBody& body) {
    guest.command(body);
    for (int i = 0; i < 5 && (guest.results.empty() || guest.results.back().sequence != guest.sequence); ++i)
      turn(1);
    return guest.results.empty() ? CommandResult{} : guest.results.back();
  }
  Vec3 press_a_while() {
    for (int t = 0; t < 60; ++t) {
      bo.bus->publish(bo.hand_at(test::press(static_cast<std::uint64_t>(t))));
      turn(1);
    }
    return hosted.simulation.soft_state(Hosted::liver).motion.x.head<3>();
  }
};

TEST_F(HandOnTime, IsTheHostsAlone) {
  for (const CommandBody& body : {CommandBody(SetPace{0}), CommandBody(StepTicks{1})}) {
    const CommandResult answer = ask(bo, body);
    EXPECT_FALSE(answer.accepted);
    EXPECT_NE(answer.reason.find("only the host"), std::string::npos) << answer.reason;
  }
  EXPECT_EQ(ask(bo, ResetAll{}).reason, "only the host can rewind");
  const std::uint64_t before = tick();
  turn(5);
  EXPECT_EQ(tick(), before + 5);
}

TEST_F(HandOnTime, RefusesWhatIsOutOfBounds) {
  EXPECT_NE(ask(ada, SetPace{min_pace / 2}).reason.find("allowed"), std::string::npos);
  for (const std::uint32_t steps : {0u, most_steps + 1})
    EXPECT_NE(ask(ada, StepTicks{steps}).reason.find("allowed"), std::string::npos) << steps;
  EXPECT_EQ(ada.replica.time().pace(), 1);
}

TEST_F(HandOnTime, StopsEveryThingWhilePeopleComeAndGo) {
  EXPECT_TRUE(ask(ada, SetPace{0}).accepted);
  turn(2);
  const std::uint64_t before = tick(), hash = hosted.simulation.state_hash();
  bo.bus->publish(bo.hand_at({0, 0.1, 0.05}));
  Guest eve = hosted.guest(3, BusEnd::observer);
  eve.greet("eve", Role::observer);
  turn(30);
  eve.take();
  EXPECT_EQ(tick(), before);
  EXPECT_EQ(hosted.simulation.state_hash(), hash);
  ASSERT_FALSE(eve.results.empty());
  EXPECT_TRUE(eve.results[0].accepted);
  EXPECT_TRUE(eve.replica.complete()) << eve.replica.missing();
  EXPECT_EQ(eve.replica.time().pace(), 0) << "who comes later is told, too";
  EXPECT_TRUE(bo.replica.roster().contains(3));
  EXPECT_NE(ask(bo, Undo{}).reason.find("time is stopped"), std::string::npos);
  eve.command(Leave{});
  turn(2);
  EXPECT_FALSE(bo.replica.roster().contains(3));
  EXPECT_TRUE(ask(ada, SetPace{1}).accepted);
  turn(10);
  EXPECT_GE(tick(), before + 10);
  EXPECT_EQ(bo.replica.time().pace(), 1);
}

TEST_F(HandOnTime, StepsAsManyTicksAsAsked) {
  EXPECT_TRUE(ask(ada, SetPace{0}).accepted);
  turn(2);
  const std::uint64_t before = tick();
  EXPECT_TRUE(ask(ada, StepTicks{7}).accepted);
  turn(30);
  EXPECT_EQ(tick(), before + 7);
}

TEST_F(HandOnTime, ResetsEverythingToTheBeginningAlsoWhileTimeStandsStill) {
  const VecX at_rest = hosted.simulation.soft_state(Hosted::liver).motion.x;
  press_a_while();
  ASSERT_GT((hosted.simulation.soft_state(Hosted::liver).motion.x - at_rest).lpNorm<Eigen::Infinity>(), 1e-3);
  EXPECT_TRUE(ask(ada, SetPace{0}).accepted);
  turn(2);
  const SimTime before = hosted.simulation.time();
  EXPECT_TRUE(ask(ada, ResetAll{}).accepted);
  turn(3);
  EXPECT_EQ(hosted.simulation.time().tick, before.tick + 1);
  EXPECT_EQ(hosted.simulation.time().epoch, before.epoch + 1);
  EXPECT_LT((hosted.simulation.soft_state(Hosted::liver).motion.x - at_rest).lpNorm<Eigen::Infinity>(), 1e-4);
}

TEST_F(HandOnTime, SaysHowExactlyTissueIsSolved) {
  const auto ask_effort = [&](Guest& guest, const CommandBody& body) {
    guest.command(body);
    turn(3);
    return guest.results.back();
  };
  const auto steps_down = [&] { return hosted.simulation.soft_state(Hosted::liver).steps_down; };
  EXPECT_EQ(ask_effort(bo, SetEffort{Hosted::liver, 1}).reason, "only the host can change the solver effort");
  EXPECT_NE(ask_effort(ada, SetEffort{1, 1}).reason.find("rigid"), std::string::npos);
  EXPECT_NE(ask_effort(ada, SetEffort{9, 1}).reason.find("no body"), std::string::npos);
  EXPECT_NE(ask_effort(ada, SetEffort{Hosted::liver, 4}).reason.find("allowed"), std::string::npos);
  EXPECT_EQ(steps_down(), 0);
  EXPECT_TRUE(ask_effort(ada, SetEffort{Hosted::liver, 2}).accepted);
  EXPECT_EQ(steps_down(), 2);
  EXPECT_TRUE(ask_effort(ada, SetAllEfforts{3}).accepted);
  EXPECT_EQ(steps_down(), 3);
  EXPECT_TRUE(ask_effort(ada, SetAllEfforts{0}).accepted);
  EXPECT_EQ(steps_down(), 0);
}

TEST(EffortDial, TakesTheLessExactOfWhatHostAndOverloadAskFor) {
  EffortDial dial;
  EXPECT_EQ(dial.host({4, 1}).steps_down, 1);
  EXPECT_EQ(dial.overload({4, 3}).steps_down, 3);
  EXPECT_EQ(dial.host({4, 2}).steps_down, 3);
  EXPECT_EQ(dial.overload({4, 0}).steps_down, 2);
  EXPECT_EQ(dial.overload({5, 1}).steps_down, 1) << "another body";
}

TEST(TickSchedule, WaitsAsLongAsThePaceAsks) {
  TickSchedule schedule(100, 0);
  std::vector<std::int64_t> due;
  for (const double pace : {1.0, 0.25, 1.0, 1.0}) {
    due.push_back(schedule.due_ns());
    schedule.set_pace(pace);
    schedule.finished(schedule.due_ns());
  }
  EXPECT_EQ(due, (std::vector<std::int64_t>{0, 10'000'000, 50'000'000, 60'000'000}));
}

}  // namespace
}  // namespace prosector
