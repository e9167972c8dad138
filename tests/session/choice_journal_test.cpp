// A choice is an input of the run: what the journal keeps replays on a machine that would choose otherwise.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "common/error.h"
#include "server/session/journal/replay.h"
#include "tests/calibration/tables.h"
#include "tests/session/hosted.h"

namespace prosector {
namespace {

SceneDesc scene_with_need() {
  SceneDesc scene = test::hosted_scene();
  scene.soft[0].choice.accuracy.value = 10;
  return scene;
}

/// By a made-up machine that is `slower` times as slow with multigrid.
std::vector<Choice> choose_on(SceneDesc& scene, double slower) {
  ChoiceOptions options;
  options.sources = test::options();
  options.on_the_body = false;  // the table is made up, too
  options.measure = [=](const RungTrial& trial) {
    RungFigures figures = test::made_up(trial);
    if (trial.rung.solver == "multigrid") figures.ms *= slower;
    return figures;
  };
  return choose_rungs(scene, options);
}

TEST(ChoiceJournal, ReplaysWithoutTheTableOfItsMachine) {
  const auto file = std::filesystem::temp_directory_path() / ("choice." + std::to_string(getpid()));
  std::filesystem::remove(file);
  SceneDesc chosen = scene_with_need();
  const auto choices = choose_on(chosen, 0.1);
  ASSERT_EQ(choices.size(), 1u);
  {
    Simulation simulation(chosen, test::options());
    const auto journal =
        Journal::create(file, {"choice.toml", "", "prosector", simulation.content_hash(), choices}, {});
    LocalNetwork network({});
    const auto bus = network.join(test::Hosted::config(BusEnd::server));
    ServerLoop loop(simulation, *bus, "prosector", journal.get(), [](const std::string&) {},
                    {.choices = choices});
    EXPECT_NE(loop.content().scene.bodies[test::Hosted::liver].method.find("accuracy 10 % requested"),
              std::string::npos);
    EXPECT_EQ(loop.body_meter().newest().at(test::Hosted::liver).expected_ms, choices[0].expected.ms);
    for (int i = 0; i < 5; ++i) loop.tick();
  }
  const JournalReader journal(file);
  SceneDesc elsewhere = scene_with_need();
  EXPECT_NE(encode(choose_on(elsewhere, 10)), encode(choices)) << "another machine chooses otherwise";
  Simulation other(elsewhere, test::options());
  EXPECT_THROW(replay(journal, other, {}), InputError);

  SceneDesc replayed = scene_with_need();
  adopt(journal.header().choices, replayed);
  Simulation again(replayed, test::options());
  const ReplayResult result = replay(journal, again, {});
  EXPECT_TRUE(result);
  EXPECT_EQ(result.ticks, 5u);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace prosector
