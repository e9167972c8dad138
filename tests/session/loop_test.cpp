// The server as its clients see it, over the in-process network.

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>

#include "common/error.h"
#include "server/session/journal/journal_reader.h"
#include "server/session/journal/replay.h"
#include "tests/session/hosted.h"
#include "tests/session/temporary_file.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;
using test::Guest;
using test::Hosted;

std::vector<HandRef> holders(const Replica& replica, BodyId body) {
  const PartState* part = replica.part(body);
  return part != nullptr ? part->holders : std::vector<HandRef>{};
}

/// Joins ada, who presses the block for `ticks` ticks.
struct Pressing {
  explicit Pressing(Hosted& hosted) : hosted(hosted), ada(hosted.guest(1, BusEnd::dissector)) {
    hosted.tick();
    ada.greet("ada", Role::dissector);
    hosted.tick();
    hosted.tick();
    ada.take();
  }
  void run(std::uint64_t ticks) {
    for (std::uint64_t i = 0; i < ticks; ++i) {
      ada.bus->publish(ada.hand_at(test::press(t++)));
      hosted.tick();
      ada.take();
    }
  }
  /// The status counts real time: wait for the next.
  const ServerStatus& status() {
    std::this_thread::sleep_for(110ms);
    run(1);
    return ada.replica.status().value();
  }
  Hosted& hosted;
  Guest ada;
  std::uint64_t t = 0;
};

TEST(ServerLoop, AHandJoinsPressesAndIsSeen) {
  Hosted hosted;
  Pressing pressing(hosted);
  ASSERT_EQ(pressing.ada.results.size(), 1u);
  EXPECT_TRUE(pressing.ada.results[0].accepted);
  pressing.run(80);
  const Replica& seen = pressing.ada.replica;
  EXPECT_TRUE(seen.complete()) << seen.missing();
  EXPECT_EQ(seen.roster().at(1).name, "ada");
  ASSERT_NE(seen.contact(1, right_hand), nullptr);
  EXPECT_TRUE(seen.contact(1, right_hand)->touching);
  EXPECT_EQ(seen.contact(1, right_hand)->body, Hosted::liver);
  EXPECT_EQ(pressing.status().participants, 1u);
  EXPECT_GT(hosted.loop.figures().max_displacement_mm.at("liver"), 5);
  EXPECT_LT(test::surface_error(hosted, pressing.ada), 1e-4);
  EXPECT_EQ(hosted.loop.figures().invalid_dropped, 0u);
}

// As a fault in the physics might make a state whose bytes no checkpoint may have.
TEST(ServerLoop, ACheckpointThatCannotBeRestoredIsSkippedAndTheSessionGoesOn) {
  const test::TemporaryFile file("refused.journal");
  const auto journal = Journal::create(
      file.path,
      {"hosted.toml", "", "prosector", Simulation(test::hosted_scene(), test::options()).content_hash(), {}},
      {});
  Simulation* saved = nullptr;
  int made = 0;
  const auto checkpoint = [&] {
    if (++made != 2) return saved->checkpoint();
    throw InputError("checkpoint: a number is not finite before byte 7");
  };
  LoopOptions loop_options;
  loop_options.checkpoint = checkpoint;
  Hosted hosted({}, journal.get(), 1, test::hosted_scene(), loop_options);
  saved = &hosted.simulation;
  Pressing pressing(hosted);
  while (made < 3) pressing.run(1);
  pressing.run(20);
  EXPECT_EQ(hosted.loop.figures().refused_checkpoints, 1u);
  EXPECT_EQ(pressing.ada.replica.roster().size(), 1u);
  const auto reported = [](const std::string& line) {
    return line.find("cannot be restored and is skipped (1 so far)") != std::string::npos;
  };
  EXPECT_EQ(std::ranges::count_if(hosted.log, reported), 1);
  // A replay rebuilds its state at the checkpoints that were made, and not at the one that was refused.
  ASSERT_TRUE(journal->settle());
  Simulation again(test::hosted_scene(), test::options());
  const ReplayResult replayed = replay(JournalReader(file.path), again, {});
  EXPECT_TRUE(replayed);
  EXPECT_EQ(replayed.ticks, hosted.simulation.time().tick);
}

TEST(ServerLoop, ALateComerSeesTheSameInMotion) {
  Hosted hosted;
  Pressing pressing(hosted);
  pressing.run(50);  // going down
  ASSERT_FALSE(hosted.simulation.asleep(Hosted::liver));
  Guest eve = hosted.guest(2, BusEnd::observer);
  eve.greet("eve", Role::observer);
  pressing.run(5);
  EXPECT_EQ(pressing.status().participants, 1u);
  EXPECT_EQ(pressing.status().observers, 1u);
  EXPECT_NE(hosted.loop.console_line().find("1 participant, 1 observer"), std::string::npos);
  EXPECT_EQ(hosted.loop.figures().participants, 1u);
  eve.take();
  EXPECT_TRUE(eve.replica.complete()) << eve.replica.missing();
  EXPECT_LT(test::surface_error(hosted, eve), 1e-4);
  EXPECT_EQ(eve.replica.roster().size(), 2u);
  EXPECT_EQ(eve.replica.bodies().topology_hash(), pressing.ada.replica.bodies().topology_hash());
  // What came to rest before: the ball, which fell from where the scene has it.
  const Pose ball = hosted.simulation.rigid_state(1).pose;
  EXPECT_GT((ball.p - hosted.simulation.scene().rigid[1].pose.p).norm(), 0.1);
  EXPECT_LT((eve.replica.rigid_pose(1, 1e9).p - ball.p).norm(), 1e-3);
}

TEST(ServerLoop, EveryoneKnowsWhoHoldsWhatAndWhoeverComesLater) {
  Hosted hosted;
  Pressing pressing(hosted);
  pressing.run(70);
  pressing.ada.command(Grasp{});
  pressing.run(3);
  pressing.ada.take();
  const HandRef by_ada{1, right_hand};
  ASSERT_EQ(holders(pressing.ada.replica, Hosted::liver), std::vector<HandRef>{by_ada});
  Guest eve = hosted.guest(2, BusEnd::observer);
  eve.greet("eve", Role::observer);
  pressing.run(3);
  eve.take();
  EXPECT_EQ(holders(eve.replica, Hosted::liver), std::vector<HandRef>{by_ada});
  EXPECT_TRUE(holders(eve.replica, 1).empty());
  pressing.ada.command(Release{});
  pressing.run(3);
  eve.take();
  EXPECT_TRUE(holders(eve.replica, Hosted::liver).empty());
}

TEST(ServerLoop, AHolderThatIsMadeAnObserverHoldsNothing) {
  Hosted hosted;
  Guest hana = hosted.guest(3, BusEnd::dissector);
  hana.greet("hana", Role::host);
  Pressing pressing(hosted);
  pressing.run(70);
  pressing.ada.command(Grasp{});
  pressing.run(3);
  ASSERT_EQ(hosted.simulation.hands().size(), 1U);
  ASSERT_TRUE(hosted.simulation.hands()[0].holding);
  hana.command(SetRole{1, Role::observer});
  pressing.run(3);  // and ada goes on sending hands
  EXPECT_TRUE(hosted.simulation.hands().empty());
  hana.take();
  EXPECT_EQ(hana.replica.roster().at(1).role, Role::observer);
  EXPECT_TRUE(holders(hana.replica, Hosted::liver).empty());
  hana.command(SetRole{1, Role::dissector});
  pressing.run(3);
  EXPECT_EQ(hosted.simulation.hands().size(), 1U);
}

TEST(ServerLoop, LostChunksAreHealedBySettled) {
  Hosted hosted({.seed = 4, .loss = 0.3, .delay = 5ms, .jitter = 2ms, .stepped = true});
  Pressing pressing(hosted);
  pressing.run(120);
  for (int i = 0; i < 1500 && !hosted.simulation.asleep(Hosted::liver); ++i) pressing.run(1);
  ASSERT_TRUE(hosted.simulation.asleep(Hosted::liver));
  pressing.run(60);
  EXPECT_TRUE(pressing.ada.replica.complete()) << pressing.ada.replica.missing();
  EXPECT_LT(test::surface_error(hosted, pressing.ada), 1e-6);  // float, not quantised
}

TEST(ServerLoop, WhatAnObserverSendsChangesNoBit) {
  std::vector<std::uint64_t> hashes;
  for (const bool garbage : {false, true}) {
    Hosted hosted;
    Pressing pressing(hosted);
    // A dissector's end of the network in an observer's role: it can send hands and tries to.
    Guest eve = hosted.guest(2, BusEnd::dissector);
    eve.greet("eve", Role::observer);
    for (int i = 0; i < 60; ++i) {
      if (garbage) {
        eve.bus->publish(eve.hand_at({0, 0.03, 0}));
        Guest mask{};  // and speaks in ada's name
        mask.id = 1;
        mask.sequence = 1'000'000 + static_cast<std::uint64_t>(i);
        eve.bus->publish(mask.hand_at({0, -1, 0}));
        eve.command(i % 2 == 0 ? CommandBody(ResetBody{}) : CommandBody(Grasp{}));
      }
      pressing.run(1);
      eve.take();
    }
    hashes.push_back(hosted.simulation.state_hash());
    if (garbage) {
      EXPECT_GT(hosted.loop.session().output().dropped_total(), 100u);
      EXPECT_FALSE(eve.results.back().accepted);
    }
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(ServerLoop, AFloodIsCountedAndTheSessionGoesOn) {
  Hosted hosted;
  Pressing pressing(hosted);
  pressing.run(10);
  Guest mallory = hosted.guest(3, BusEnd::dissector);
  mallory.greet("mallory", Role::dissector);
  for (int i = 0; i < 30; ++i) {
    HandInput bad = mallory.hand_at({0, std::numeric_limits<double>::quiet_NaN(), 0});
    EXPECT_FALSE(mallory.bus->publish(bad));  // not even sent; idl's tests try what others may send
    for (int k = 0; k < 50; ++k) {
      mallory.command(Grasp{});
      mallory.bus->publish(pressing.ada.hand_at({0, 0, 0}));
    }
    pressing.run(1);
  }
  EXPECT_GT(hosted.loop.figures().invalid_dropped, 500u);
  EXPECT_TRUE(pressing.ada.replica.complete());
  EXPECT_GT(pressing.status().invalid_dropped, 500u);
  EXPECT_EQ(hosted.loop.session().roster().members().count(1), 1u);
}

TEST(ServerLoop, AStreamThatStopsAndAClientThatDiesLetGo) {
  Hosted hosted;
  Pressing pressing(hosted);
  pressing.run(20);
  ASSERT_EQ(hosted.simulation.hands().size(), 1u);
  for (int i = 0; i < 300; ++i) hosted.tick();  // 5 s: a client that stalls
  EXPECT_EQ(hosted.simulation.hands().size(), 1u);
  for (int i = 0; i < 10; ++i) hosted.tick();
  EXPECT_TRUE(hosted.simulation.hands().empty());
  pressing.run(5);
  ASSERT_EQ(hosted.simulation.hands().size(), 1u);
  hosted.network.crash(*pressing.ada.bus);
  for (int i = 0; i < 120; ++i) hosted.tick();
  EXPECT_TRUE(hosted.simulation.hands().empty());
  EXPECT_TRUE(hosted.loop.session().roster().members().empty());
}

TEST(ServerLoop, AnotherRunIsAnotherNumber) {
  std::uint64_t runs[2];
  for (std::uint64_t& run : runs) {
    Hosted hosted;
    Guest eve = hosted.guest(1, BusEnd::observer);
    hosted.tick();
    eve.take();
    run = eve.replica.session().value().server_run;
  }
  EXPECT_NE(runs[0], runs[1]);
}

/// A network that takes its time to hand over what arrived: a stand-in for any step that is too slow.
class SlowBus final : public Bus {
 public:
  explicit SlowBus(Bus& inner) : inner_(inner) {}
  bool publish(const Message& m) override { return inner_.publish(m); }
  void dispose(const Message& m) override { inner_.dispose(m); }
  void take(std::vector<Received>& out) override {
    std::this_thread::sleep_for(40ms);
    inner_.take(out);
  }
  bool wait(std::chrono::milliseconds timeout) override { return inner_.wait(timeout); }
  BusCounters counters() const override { return inner_.counters(); }

 private:
  Bus& inner_;
};

TEST(ServerLoop, LateStepsSlowTimeAndSaySo) {
  LocalNetwork network({});
  Simulation simulation(test::hosted_scene(), test::options());
  const auto bus = network.join(Hosted::config(BusEnd::server));
  SlowBus slow(*bus);
  ServerLoop loop(simulation, slow, "prosector", nullptr, [](const std::string&) {});
  const std::atomic<bool> stop{false};
  std::string line;
  loop.run(stop, 1.4, [&](const std::string& l) { line = l; });
  EXPECT_LT(loop.figures().real_time_factor, 0.5);
  EXPECT_GT(loop.figures().real_time_factor, 0.2);
  EXPECT_GT(loop.figures().slips, 10u);
  EXPECT_EQ(loop.figures().late_ticks, loop.figures().ticks);
  EXPECT_NE(line.find("slowed"), std::string::npos) << line;
}

TEST(ServerLoop, KeepsItsRate) {
  Hosted hosted;
  const std::atomic<bool> stop{false};
  hosted.loop.run(stop, 1, [](const std::string&) {});
  EXPECT_GE(hosted.loop.figures().real_time_factor, 0.9);  // a busy machine may take a little
  EXPECT_LE(hosted.loop.figures().real_time_factor, 1.05);
}

TEST(BodyMeter, SaysOfABodyThatNeverWokeHowItWillBeStepped) {
  const auto status_of = [](const char* model, const char* integrator, double damping = 0.01) {
    SceneDesc scene = test::hosted_scene();
    scene.soft[0].configuration.model = model;
    scene.soft[0].configuration.integrator = integrator;
    scene.soft[0].configuration.substeps = 7;
    scene.soft[0].material.damping_stiffness = damping;
    const Simulation simulation(scene, test::options());
    return BodyMeter(simulation, {}).newest().at(Hosted::liver);
  };
  const double tick = 1. / 60;
  EXPECT_EQ(status_of("fem_corotational", "implicit_euler").substeps, 0u);
  EXPECT_EQ(status_of("fem_corotational", "implicit_euler").step, tick);
  EXPECT_EQ(status_of("xpbd", "implicit_euler").substeps, 7u);
  EXPECT_EQ(status_of("xpbd", "implicit_euler").step, tick / 7);
  EXPECT_GT(status_of("fem_corotational", "symplectic_euler").substeps, 1u);
  // Undamped it holds at no step: implicit Euler will step it.
  EXPECT_EQ(status_of("fem_corotational", "explicit_euler", 0).substeps, 0u);
}

}  // namespace
}  // namespace prosector
