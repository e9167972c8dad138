// Bodies that a host has modelled in another way while the session runs.

#include "server/session/run/remodeller.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "server/session/journal/replay.h"
#include "tests/calibration/tables.h"
#include "tests/session/recorded.h"

namespace prosector {
namespace {

using test::Guest;
using test::Hosted;
using test::hosted_scene;
using test::options;
using test::TemporaryFile;
using namespace std::chrono_literals;

SceneDesc described() {
  return hosted_scene();
}

/// Returns figures of a machine on which errors halve as the mesh gets twice as fine, and quadratic elements
/// are three times as right and six times as dear.
RungFigures slowly_converging(const RungTrial& trial) {
  RungTrial exact = trial;
  exact.cells = 1'000'000;
  exact.rung.model = "fem_neo_hookean";
  RungFigures out = test::made_up(trial);
  const double error = (trial.rung.element == "tet10" ? 1. / 3 : 1) / trial.cells;
  out.settled_sag = test::made_up(exact).settled_sag * (1 - error);
  return out;
}

/// A server whose host may ask for another accuracy.
struct Dialled {
  Dialled() : network({}), remodeller(hooks()), bus(network.join(Hosted::config(BusEnd::server))) {
    scene.simulation = std::make_unique<Simulation>(described(), options());
    begin(nullptr);
    ada.bus = network.join(Hosted::config(BusEnd::dissector));
    ada.id = 1;
    ada.greet("ada", Role::host);
    turn(3);
  }

  LocalNetwork network;
  std::atomic<bool> ready{false};
  std::vector<std::string> log;
  Remodeller remodeller;
  std::unique_ptr<Bus> bus;
  ReadyScene scene;
  std::unique_ptr<ServerLoop> loop;
  Guest ada;

  Remodeller::Hooks hooks() {
    ChoiceOptions choosing{.table_file = {},
                           .machine = "made up",
                           .measure = slowly_converging,
                           .on_the_body = false,  // trials have their own tests, and take time
                           .sources = options()};
    return {.describe = described,
            .choosing = choosing,
            .compile = [](const SceneDesc& s) { return std::make_unique<Simulation>(s, options()); },
            .ready = [this] { ready = true; }};
  }
  void begin(Journal* journal) {
    loop.reset();
    remodeller.begin(scene.choices);
    loop = std::make_unique<ServerLoop>(
        *scene.simulation, *bus, "prosector", journal,
        [this](const std::string& line) { log.push_back(line); },
        LoopOptions{.choices = scene.choices, .remodeller = &remodeller});
  }
  void turn(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      loop->turn();
      loop->publisher().flush();
      network.advance(16667us);
      ada.take();
    }
  }
  CommandResult ask(Guest& guest, BodyId body, double percent) {
    guest.command(SetAccuracy{body, percent});
    turn(3);
    guest.take();
    return guest.answer();
  }
  /// Returns the words that are no answer, once there are any.
  std::string hear() {
    for (int i = 0; i < 6000; ++i) {
      turn(1);
      for (const CommandResult& result : ada.results)
        if (result.sequence == 0) return result.reason;
      std::this_thread::sleep_for(10ms);
    }
    return {};
  }
};

/// What was chosen is proved once the session runs. A wish is answered before that is done.
TEST(Remodeller, AProofIsPutOff) {
  std::atomic<int> steps{0};
  const auto describe = [] {
    SceneDesc scene = described();
    scene.soft.front().choice.accuracy.value = 10;
    return scene;
  };
  Remodeller::Hooks hooks{.describe = describe,
                          .choosing = {.table_file = {},
                                       .machine = "made up",
                                       .measure =
                                           [&](const RungTrial& trial) {
                                             ++steps;
                                             return slowly_converging(trial);
                                           },
                                       .sources = options()},
                          .compile = {},
                          .ready = [] {},
                          .say = {}};
  const auto started = std::chrono::steady_clock::now();
  {
    Remodeller remodeller(std::move(hooks));
    std::vector<Choice> choices(1);
    choices[0].body = describe().soft.front().name;
    remodeller.begin(choices);
    while (steps == 0 && std::chrono::steady_clock::now() < started + 60s) std::this_thread::sleep_for(1ms);
    EXPECT_GT(steps, 0) << "it began by itself";
    remodeller.ask({1, 1, "nobody", 0});
    std::vector<AccuracyAnswer> answers;
    while (answers.empty() && std::chrono::steady_clock::now() < started + 60s) {
      std::this_thread::sleep_for(1ms);
      answers = remodeller.take_answers();
    }
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_NE(answers[0].words.find("nobody"), std::string::npos);
  }
}

TEST(Remodeller, OnlyTheHostAsksAndOnlyForWhatThereIs) {
  Dialled dialled;
  Guest bo;
  bo.bus = dialled.network.join(Hosted::config(BusEnd::dissector));
  bo.id = 2;
  bo.greet("bo", Role::dissector);
  dialled.turn(3);
  EXPECT_EQ(dialled.ask(bo, Hosted::liver, 30).reason, "only the host can set the accuracy");
  EXPECT_NE(dialled.ask(dialled.ada, 0, 30).reason.find("rigid"), std::string::npos);
  EXPECT_NE(dialled.ask(dialled.ada, 9, 30).reason.find("no body"), std::string::npos);
  EXPECT_NE(dialled.ask(dialled.ada, Hosted::liver, 0.01).reason.find("allowed"), std::string::npos);
  Hosted without;
  Guest host = without.guest(1, BusEnd::dissector);
  host.greet("ada", Role::host);
  without.tick();
  host.command(SetAccuracy{Hosted::liver, 0});
  for (int i = 0; i < 3; ++i) without.tick();
  host.take();
  EXPECT_NE(host.answer().reason.find("cannot remodel"), std::string::npos) << host.answer().reason;
}

TEST(Remodeller, TellsWhatABodyCanHave) {
  Dialled dialled;
  ASSERT_TRUE(dialled.ask(dialled.ada, Hosted::liver, 0).accepted);
  const std::string words = dialled.hear();
  EXPECT_NE(words.find("liver: available accuracies: "), std::string::npos) << words;
  dialled.turn(40);
  const BodyStatus* status = dialled.ada.replica.body_status(Hosted::liver);
  ASSERT_NE(status, nullptr);
  ASSERT_GE(status->prices.size(), 2u) << words;
  for (std::size_t k = 1; k < status->prices.size(); ++k) {
    EXPECT_LT(status->prices[k].error, status->prices[k - 1].error);
    EXPECT_GE(status->prices[k].ms, status->prices[k - 1].ms);
  }
  EXPECT_FALSE(dialled.ready) << "nothing is changed by a question";
}

TEST(Remodeller, SaysWhatIsBestWhereNothingIsGoodEnough) {
  Dialled dialled;
  ASSERT_TRUE(dialled.ask(dialled.ada, Hosted::liver, 0.1).accepted);
  EXPECT_EQ(dialled.hear().find("no configuration reaches 0.1 %: liver: available accuracies: "), 0u);
  EXPECT_FALSE(dialled.ready);
}

/// The session goes on with the body modelled anew, in a journal of its own, which a replay repeats.
TEST(Remodeller, TheSessionGoesOnInAnotherModelAndReplays) {
  Dialled dialled;
  for (std::uint64_t t = 0; t < 60; ++t) {
    dialled.ada.bus->publish(dialled.ada.hand_at(test::press(t)));
    dialled.turn(1);
  }
  ASSERT_TRUE(dialled.ask(dialled.ada, Hosted::liver, 30).accepted);
  for (int i = 0; i < 6000 && !dialled.ready; ++i) {
    dialled.turn(1);
    std::this_thread::sleep_for(10ms);
  }
  ASSERT_TRUE(dialled.ready);
  std::optional<ReadyScene> next = dialled.remodeller.take();
  ASSERT_TRUE(next);
  const SimTime before = dialled.scene.simulation->time();
  ASSERT_FALSE(next->simulation->take_over(*dialled.scene.simulation));
  EXPECT_EQ(next->simulation->time().tick, before.tick);
  EXPECT_LE(next->choices.front().expected.error, 0.3);

  TemporaryFile file("remodelled.journal");
  JournalHeader header{"scene.toml", "", "prosector", next->simulation->content_hash(), next->choices};
  header.begins_at = before.tick;
  header.beginning = next->simulation->checkpoint();
  const std::uint64_t taken_over = next->simulation->state_hash();
  auto journal = Journal::create(file.path, header, {});
  const std::unique_ptr<Simulation> old = std::exchange(dialled.scene, std::move(*next)).simulation;
  dialled.begin(journal.get());
  dialled.ada.greet("ada", Role::host);  // as clients do, who find themselves forgotten
  EXPECT_NE(dialled.hear().find("liver is remodelled: expected "), std::string::npos);
  dialled.turn(30);
  dialled.loop->finish();
  const std::uint64_t last = dialled.scene.simulation->state_hash();
  journal.reset();

  const JournalReader reader(file.path);
  EXPECT_EQ(reader.header().begins_at, before.tick);
  SceneDesc again = described();
  adopt(reader.header().choices, again);
  Simulation replayed(again, options());
  replayed.restore(reader.header().beginning);
  EXPECT_EQ(replayed.state_hash(), taken_over);
  const ReplayResult result = replay(reader, replayed, {});
  EXPECT_TRUE(result) << "tick " << result.first_difference.value_or(0) << " differs";
  EXPECT_GT(result.ticks, 30u);
  EXPECT_EQ(result.last_hash, last);
}

}  // namespace
}  // namespace prosector
