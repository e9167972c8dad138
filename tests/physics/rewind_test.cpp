// Going back to earlier states of what was cut, and taking cuts back, over strokes at random.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "idl/message.h"
#include "server/physics/mechanics/organs/blade.h"
#include "tests/physics/scalpel.h"

namespace prosector::test {
namespace {

/// What a rewind has to bring back.
struct Moment {
  std::shared_ptr<const std::vector<std::uint8_t>> state;
  std::vector<std::uint64_t> meshes;  // content hash of each soft body
  std::vector<VecX> x;
};

bool is_whole(const Simulation& simulation, BodyId body) {
  return !simulation.surface(body).triangles.empty();
}

Moment moment_of(const Simulation& simulation) {
  Moment out;
  out.state = std::make_shared<const std::vector<std::uint8_t>>(simulation.save());
  for (BodyId body = 1; body < simulation.body_count(); ++body) {
    out.meshes.push_back(is_whole(simulation, body) ? simulation.soft(body).content_hash() : 0);
    out.x.push_back(simulation.soft_state(body).motion.x);
  }
  return out;
}

TickInput rewind_to(const Moment& moment) {
  TickInput input;
  input.cuts = {{CutEvent::Kind::rewind, somebody, 0, 0, moment.state}};
  return input;
}

void expect_moment(const Simulation& simulation, const Moment& then) {
  const Moment now = moment_of(simulation);
  ASSERT_GE(now.meshes.size(), then.meshes.size());
  for (std::size_t i = 0; i < now.meshes.size(); ++i) {
    EXPECT_EQ(now.meshes[i], i < then.meshes.size() ? then.meshes[i] : 0) << "body " << i + 1;
    if (i < then.x.size()) {
      EXPECT_EQ(now.x[i], then.x[i]) << "body " << i + 1;
    }
  }
}

/// All that can be cut, whoever has it now.
double all_mass(const Simulation& simulation) {
  double sum = 0;
  for (BodyId body = 1; body < simulation.body_count(); ++body)
    if (is_whole(simulation, body)) sum += simulation.soft(body).total_mass();
  return sum;
}

/// The block without ties to where it is, and so tender that a fast blade goes through.
SceneDesc tender_block() {
  SceneDesc scene = block_and_scalpel();
  scene.soft[0].material.toughness = 0;
  scene.soft[0].attach[0].stiffness = 1e5;
  return scene;
}

/// Draws the scalpel through the block from one random side to another, over some ticks; each that cut is
/// noted. Whether it cut anything.
bool stroke(Simulation& simulation, std::mt19937_64& random, std::vector<Moment>& moments) {
  std::uniform_real_distribution<double> share(-1, 1);
  const double way = M_PI * share(random);
  const Vec3 along(std::cos(way), 0, std::sin(way)), across(-along.z(), 0, along.x());
  const Vec3 middle(0.03 * share(random), 0.135 + 0.02 * share(random), 0.03 * share(random));
  const double reach = 0.12, turn = 0.6 * share(random);
  const Quat held(Eigen::AngleAxisd(turn, along));
  const Vec3 begin = middle - reach * along + 0.01 * share(random) * across;
  bool cut = false;
  const auto move_to = [&](const Vec3& at) {
    if (simulation.step(target(at, held)).topology.empty()) return;
    moments.push_back(moment_of(simulation));
    cut = true;
  };
  for (int i = 0; i < 8; ++i) move_to(begin + Vec3(0, 0.1, 0));  // round the block, above it
  for (int i = 0; i < 8; ++i) move_to(begin);
  for (int i = 0; i <= 14; ++i) move_to(begin + i / 14.0 * 2 * reach * along);
  return cut;
}

/// The hand goes round the block to where the scalpel lies at first, which is put there. Whether it has it:
/// a piece may lie in between.
bool take_again(Simulation& simulation) {
  const Vec3 at(-0.12, 0.14, 0.02);
  for (int i = 0; i < 15; ++i) simulation.step(target({-0.12, 0.3, 0.02}));
  for (int i = 0; i < 15; ++i) simulation.step(target(at));
  TickInput put = target(at);
  put.events = {{HandEvent::Kind::reset_body, somebody, right_hand, scalpel}};
  simulation.step(put);
  simulation.step(event(HandEvent::Kind::grasp, at));
  return simulation.hands()[0].holding.has_value();
}

TEST(Rewind, BringsBackTheWholeStateInANewEpoch) {
  Simulation simulation(block_and_scalpel(), options());
  const Moment uncut = moment_of(simulation);
  Vec3 at = take(simulation);
  draw(simulation, at, 90);
  ASSERT_GT(simulation.revision(1), 3U);
  const Moment half = moment_of(simulation);
  const std::uint32_t revision_then = simulation.revision(1);
  draw(simulation, at, 60);
  ASSERT_EQ(simulation.body_count(), 3U);
  const SimTime left = simulation.time();
  const std::uint32_t revision_left = simulation.revision(1);

  const StepReport& report = simulation.step(rewind_to(half));
  ASSERT_EQ(report.cut_answers, std::vector<Refusal>(1));
  expect_moment(simulation, half);
  EXPECT_EQ(simulation.time(), (SimTime{left.epoch + 1, left.tick + 1}));
  EXPECT_EQ(simulation.body_count(), 3U) << "bodies are never taken out of the scene";
  EXPECT_TRUE(simulation.part(2).hidden);
  EXPECT_EQ(simulation.revision(1), revision_left + 1);
  EXPECT_GT(simulation.revision(1), revision_then);
  ASSERT_EQ(report.topology.size(), 2U);
  for (const TopologyChange& change : report.topology) {
    EXPECT_EQ(change.cause, TopologyCause::rewind);
    EXPECT_EQ(change.author, somebody);
    EXPECT_FALSE(change.piece_of);
  }
  EXPECT_FALSE(simulation.hands()[0].holding) << "hands let go";
  ASSERT_EQ(report.let_go.size(), 1U);
  EXPECT_EQ(simulation.step(undo()).cut_answers, std::vector<Refusal>(1))
      << "the half cut is one's own still";
  EXPECT_EQ(moment_of(simulation).meshes[0], uncut.meshes[0]);
  EXPECT_EQ(simulation.step(rewind_to(uncut)).cut_answers, std::vector<Refusal>(1));
  expect_moment(simulation, uncut);
}

TEST(Rewind, RefusesWhatIsNoStateOfThisRunAndChangesNothing) {
  Simulation simulation(tender_block(), options()), other(tender_block(), options());
  std::mt19937_64 random(2), others(3);
  std::vector<Moment> moments, foreign;
  take(simulation);
  take(other);
  stroke(simulation, random, moments);
  stroke(other, others, foreign);
  ASSERT_FALSE(foreign.empty());
  const auto cut_short = std::make_shared<const std::vector<std::uint8_t>>(foreign.back().state->begin(),
                                                                           foreign.back().state->end() - 9);
  for (const auto& state : {foreign.back().state, cut_short, decltype(cut_short){}}) {
    const Moment before = moment_of(simulation);
    const SimTime time = simulation.time();
    TickInput input;
    input.cuts = {{CutEvent::Kind::rewind, somebody, 0, 0, state}};
    const StepReport& report = simulation.step(input);
    EXPECT_NE(report.cut_answers, std::vector<Refusal>(1));
    EXPECT_TRUE(report.topology.empty());
    EXPECT_EQ(moment_of(simulation).meshes, before.meshes);
    EXPECT_EQ(simulation.time(), (SimTime{time.epoch, time.tick + 1}));
  }
}

/// Moves the hand. `draws`: it draws a cut.
void move(Simulation& simulation, const Vec3& to, bool draws) {
  TickInput input = target(to);
  input.targets[0].draws = draws;
  simulation.step(input);
}

/// Into the block's side and out again.
void nick(Simulation& simulation, double z, bool draws = false) {
  const auto move_to = [&](double x) { move(simulation, {x, 0.14, z}, draws); };
  for (int i = 0; i <= 6; ++i) move_to(-0.08 + 0.01 * i);
  for (int i = 1; i <= 2; ++i) move_to(-0.02 - 0.03 * i);
}

TEST(Undo, TakesWhatABladeCutsAgainAtOnceForTheSameCut) {
  for (const bool at_once : {true, false}) {
    Simulation simulation(tender_block(), options());
    take(simulation);
    const std::uint64_t uncut = simulation.soft(1).content_hash();
    nick(simulation, 0);
    const std::uint64_t once = simulation.soft(1).content_hash();
    ASSERT_NE(once, uncut);
    const double pause = (at_once ? 0.3 : 1.3) * organs::between_strokes;
    for (int i = 0; i < pause * simulation.scene().tick_rate; ++i)
      simulation.step(target({-0.08, 0.14, 0.03}));
    nick(simulation, 0.03);
    ASSERT_NE(simulation.soft(1).content_hash(), once);
    EXPECT_EQ(simulation.step(undo()).cut_answers, std::vector<Refusal>(1));
    EXPECT_EQ(simulation.soft(1).content_hash(), at_once ? uncut : once);
    EXPECT_EQ(simulation.step(undo()).cut_answers == std::vector<Refusal>(1), !at_once);
    EXPECT_EQ(simulation.soft(1).content_hash(), uncut);
  }
}

TEST(Undo, TakesADrawnCutBackWholeHoweverLongTheBladeWasOutMeanwhile) {
  for (const bool draws : {true, false}) {
    Simulation simulation(tender_block(), options());
    take(simulation);
    const std::uint64_t uncut = simulation.soft(1).content_hash();
    nick(simulation, 0, draws);
    const std::uint64_t once = simulation.soft(1).content_hash();
    for (int i = 0; i < 5 * organs::between_strokes * simulation.scene().tick_rate; ++i) {
      if (i == 20) simulation.restore(simulation.checkpoint());
      i % 3 == 0 ? move(simulation, {-0.08, 0.14, 0.03}, draws) : (void)simulation.step({});
    }
    nick(simulation, 0.03, draws);
    ASSERT_NE(simulation.soft(1).content_hash(), once);
    EXPECT_EQ(simulation.step(undo()).cut_answers, std::vector<Refusal>(1));
    EXPECT_EQ(simulation.soft(1).content_hash(), draws ? uncut : once);
  }
}

TEST(Undo, TakesOneOfTwoDrawnCutsHoweverFastTheyFollow) {
  Simulation simulation(tender_block(), options());
  take(simulation);
  std::vector<std::uint64_t> hashes = {simulation.soft(1).content_hash()};
  for (const bool draws : {true, false, true}) {
    nick(simulation, 0.02 * static_cast<double>(hashes.size()) - 0.04, draws);
    ASSERT_NE(simulation.soft(1).content_hash(), hashes.back());
    hashes.push_back(simulation.soft(1).content_hash());
  }
  for (hashes.pop_back(); !hashes.empty(); hashes.pop_back()) {
    EXPECT_EQ(simulation.step(undo()).cut_answers, std::vector<Refusal>(1));
    EXPECT_EQ(simulation.soft(1).content_hash(), hashes.back());
  }
}

TEST(Undo, TakesADrawnCutBackWithWhatItsBladeStillCutsWhenTheDrawingEndsInTissue) {
  Simulation simulation(tender_block(), options());
  take(simulation);
  const std::uint64_t uncut = simulation.soft(1).content_hash();
  for (int i = 0; i <= 16; ++i) move(simulation, {-0.08 + 0.005 * i, 0.14, 0}, i < 12);
  for (int i = 1; i <= 2; ++i) move(simulation, {-0.02 - 0.03 * i, 0.14, 0}, false);
  ASSERT_NE(simulation.soft(1).content_hash(), uncut);
  EXPECT_EQ(simulation.step(undo()).cut_answers, std::vector<Refusal>(1));
  EXPECT_EQ(simulation.soft(1).content_hash(), uncut);
}

TEST(Rewind, UndoAndRewindSampledOverRandomStrokes) {
  const std::uint64_t fresh = std::random_device{}();
  for (const std::uint64_t seed : {std::uint64_t{11}, fresh}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    Simulation simulation(tender_block(), options()), copy(tender_block(), options());
    const double mass = simulation.soft(1).total_mass();
    std::vector<Moment> moments = {moment_of(simulation)};
    take(simulation);
    int undone = 0, rewound = 0;
    for (int n = 0; n < 12; ++n) {
      if (!stroke(simulation, random, moments)) continue;
      ASSERT_NEAR(all_mass(simulation), mass, 1e-9 * mass);
      const auto step_both = [&](const TickInput& input) {  // the copy comes from a checkpoint
        copy.restore(simulation.checkpoint());
        EXPECT_EQ(simulation.step(input).cut_answers, std::vector<Refusal>(1));
        copy.step(input);
        EXPECT_EQ(simulation.state_hash(), copy.state_hash());
      };
      if (n % 3 == 1) {
        step_both(undo());
        // A blade that left tissue and entered it again made two strokes; all begin at a moment that was.
        const std::vector<std::uint64_t> now = moment_of(simulation).meshes;
        EXPECT_NE(now, moments.back().meshes);
        EXPECT_TRUE(std::any_of(moments.begin(), moments.end(),
                                [&](const Moment& then) {
                                  std::vector<std::uint64_t> meshes = then.meshes;
                                  meshes.resize(now.size());
                                  return meshes == now;
                                }))
            << "undo of stroke " << n;
        moments.push_back(moment_of(simulation));
        ++undone;
      } else if (n % 3 == 2) {
        const Moment then = moments[random() % moments.size()];
        step_both(rewind_to(then));
        expect_moment(simulation, then);
        moments.push_back(moment_of(simulation));
        ASSERT_NEAR(all_mass(simulation), mass, 1e-9 * mass);
        ++rewound;
        if (!take_again(simulation)) break;
      }
    }
    if (seed == fresh) continue;  // of which nobody knows what it comes upon
    EXPECT_GT(undone, 1);
    EXPECT_GT(rewound, 1);
    EXPECT_GT(simulation.body_count(), 2U) << "no stroke cut anything off";
  }
}

}  // namespace
}  // namespace prosector::test
