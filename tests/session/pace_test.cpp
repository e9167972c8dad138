// The host's hand on time: who may, what goes on while time stands still, and that nothing else changes.

#include <gtest/gtest.h>

#include "server/session/tick_schedule.h"
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
  CommandResult ask(Guest& guest, CommandKind kind, double value = 0, std::uint32_t revision = 0) {
    Command c;
    c.participant = guest.id;
    c.sequence = ++guest.sequence;
    c.kind = kind;
    c.value = value;
    c.revision = revision;
    guest.bus->publish(c);
    for (int i = 0; i < 5 && (guest.results.empty() || guest.results.back().sequence != c.sequence); ++i)
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
  for (const CommandKind kind : {CommandKind::set_pace, CommandKind::step_ticks}) {
    const CommandResult answer = ask(bo, kind, 0, 1);
    EXPECT_FALSE(answer.accepted);
    EXPECT_NE(answer.reason.find("only the host"), std::string::npos) << answer.reason;
  }
  EXPECT_EQ(ask(bo, CommandKind::reset_all).reason, "only the host rewinds");
  const std::uint64_t before = tick();
  turn(5);
  EXPECT_EQ(tick(), before + 5);
}

TEST_F(HandOnTime, RefusesWhatIsOutOfBounds) {
  EXPECT_NE(ask(ada, CommandKind::set_pace, least_pace / 2).reason.find("allowed"), std::string::npos);
  for (const std::uint32_t steps : {0u, most_steps + 1})
    EXPECT_NE(ask(ada, CommandKind::step_ticks, 0, steps).reason.find("allowed"), std::string::npos) << steps;
  EXPECT_EQ(ada.replica.pace(), 1);
}

TEST_F(HandOnTime, StopsEveryThingWhilePeopleComeAndGo) {
  EXPECT_TRUE(ask(ada, CommandKind::set_pace, 0).accepted);
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
  EXPECT_EQ(eve.replica.pace(), 0) << "who comes later is told, too";
  EXPECT_TRUE(bo.replica.roster().contains(3));
  EXPECT_NE(ask(bo, CommandKind::undo).reason.find("time stands still"), std::string::npos);
  eve.command(CommandKind::leave);
  turn(2);
  EXPECT_FALSE(bo.replica.roster().contains(3));
  EXPECT_TRUE(ask(ada, CommandKind::set_pace, 1).accepted);
  turn(10);
  EXPECT_GE(tick(), before + 10);
  EXPECT_EQ(bo.replica.pace(), 1);
}

TEST_F(HandOnTime, StepsAsManyTicksAsAsked) {
  EXPECT_TRUE(ask(ada, CommandKind::set_pace, 0).accepted);
  turn(2);
  const std::uint64_t before = tick();
  EXPECT_TRUE(ask(ada, CommandKind::step_ticks, 0, 7).accepted);
  turn(30);
  EXPECT_EQ(tick(), before + 7);
}

TEST_F(HandOnTime, ResetsEverythingToTheBeginningAlsoWhileTimeStandsStill) {
  const VecX at_rest = hosted.simulation.soft_state(Hosted::liver).motion.x;
  press_a_while();
  ASSERT_GT((hosted.simulation.soft_state(Hosted::liver).motion.x - at_rest).lpNorm<Eigen::Infinity>(), 1e-3);
  EXPECT_TRUE(ask(ada, CommandKind::set_pace, 0).accepted);
  turn(2);
  const SimTime before = hosted.simulation.time();
  EXPECT_TRUE(ask(ada, CommandKind::reset_all).accepted);
  turn(3);
  EXPECT_EQ(hosted.simulation.time().tick, before.tick + 1);
  EXPECT_EQ(hosted.simulation.time().epoch, before.epoch + 1);
  EXPECT_LT((hosted.simulation.soft_state(Hosted::liver).motion.x - at_rest).lpNorm<Eigen::Infinity>(), 1e-4);
}

TEST_F(HandOnTime, SaysHowExactlyTissueIsSolved) {
  const auto ask_effort = [&](Guest& guest, CommandKind kind, BodyId body, std::uint32_t steps) {
    Command c;
    c.participant = guest.id;
    c.sequence = ++guest.sequence;
    c.kind = kind;
    c.body = body;
    c.revision = steps;
    guest.bus->publish(c);
    turn(3);
    return guest.results.back();
  };
  const auto steps_down = [&] { return hosted.simulation.soft_state(Hosted::liver).steps_down; };
  EXPECT_EQ(ask_effort(bo, CommandKind::set_effort, Hosted::liver, 1).reason,
            "only the host says how exactly tissue is solved");
  EXPECT_NE(ask_effort(ada, CommandKind::set_effort, 1, 1).reason.find("rigid"), std::string::npos);
  EXPECT_NE(ask_effort(ada, CommandKind::set_effort, 9, 1).reason.find("no body"), std::string::npos);
  EXPECT_NE(ask_effort(ada, CommandKind::set_effort, Hosted::liver, 4).reason.find("allowed"),
            std::string::npos);
  EXPECT_EQ(steps_down(), 0);
  EXPECT_TRUE(ask_effort(ada, CommandKind::set_effort, Hosted::liver, 2).accepted);
  EXPECT_EQ(steps_down(), 2);
  EXPECT_TRUE(ask_effort(ada, CommandKind::set_all_efforts, 0, 3).accepted);
  EXPECT_EQ(steps_down(), 3);
  EXPECT_TRUE(ask_effort(ada, CommandKind::set_all_efforts, 0, 0).accepted);
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
