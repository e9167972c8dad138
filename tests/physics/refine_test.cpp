// Elements that are smaller where a body is touched: the same bits whatever goes on, and no trace in the end.

#include <gtest/gtest.h>

#include <random>

#include "common/error.h"
#include "tests/physics/pressed_layer.h"
#include "tests/physics/scalpel.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr double ball_radius = 0.015;  // m

/// A tied block under a fixed ball that is driven into it, as body 0.
SceneDesc pressed_block(const std::string& model = "fem_corotational",
                        const std::string& integrator = "implicit_euler") {
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  scene.rigid = {part_body("ball", "sphere", {2 * ball_radius, 0, 0}, {0, 0.1, 0})};
  scene.rigid[0].fixed = true;
  SoftDesc& soft = scene.soft.emplace_back(block());
  soft.attach = {{{0, -0.2, 0}, 0.205, 1e9}};
  soft.geometry.cell = 0.02;
  soft.refinement.at = Refining::touch;
  soft.configuration.model = model;
  soft.configuration.integrator = integrator;
  soft.material.youngs_modulus = 1e4;
  return scene;
}

constexpr BodyId pressed = 1;

CompileOptions halved(int threads = 1) {
  CompileOptions out = options(threads);
  out.anatomy = [fill = out.anatomy](const SoftDesc& desc) {
    auto anatomy = fill(desc);
    halve_surface(*anatomy);
    return anatomy;
  };
  return out;
}

TickInput press_at(double x, double depth, double z = 0) {
  TickInput input;
  input.kinematic_targets.push_back({0, {{x, 0.06 + ball_radius - depth, z}, Quat::Identity()}});
  return input;
}

/// The ball comes down, goes along, and leaves.
TickInput input_at(int tick) {
  const double depth = 0.004 * std::min(1.0, tick / 20.0);
  if (tick < 60) return press_at(0.02 * std::max(0.0, (tick - 20) / 40.0), depth);
  return press_at(0.02, -0.05);
}

void run_to(Simulation& simulation, int from, int to) {
  for (int tick = from; tick < to; ++tick) simulation.step(input_at(tick));
}

std::vector<std::uint64_t> hashes(Simulation& simulation, int from, int to) {
  std::vector<std::uint64_t> out;
  for (int tick = from; tick < to; ++tick) {
    simulation.step(input_at(tick));
    out.push_back(simulation.state_hash());
  }
  return out;
}

TEST(Refine, IsFineUnderWhatPressesAndLeavesNoTrace) {
  Simulation simulation(pressed_block(), halved());
  const std::size_t tets = tet_count(simulation);
  const std::uint64_t mesh = simulation.soft(pressed).content_hash();
  const auto rows = simulation.soft(pressed).anatomy().embedding.rows;
  run_to(simulation, 0, 60);
  EXPECT_GT(tet_count(simulation), tets + 100);
  EXPECT_NE(simulation.soft(pressed).content_hash(), mesh);
  EXPECT_EQ(simulation.topology_hash(pressed), mesh);
  EXPECT_EQ(simulation.revision(pressed), 0u);
  EXPECT_TRUE(simulation.numbering(pressed).nodes.empty());
  run_to(simulation, 60, 100);  // less than a second later
  EXPECT_GT(tet_count(simulation), tets + 100);
  run_to(simulation, 100, 260);
  EXPECT_EQ(tet_count(simulation), tets);
  EXPECT_EQ(simulation.soft(pressed).content_hash(), mesh);
  EXPECT_TRUE(std::ranges::equal(
      simulation.soft(pressed).anatomy().embedding.rows, rows,
      [](const auto& a, const auto& b) { return a.node == b.node && a.weight == b.weight; }));
  EXPECT_LT(simulation.max_displacement(pressed), 1e-5);
}

TEST(Refine, AnUntouchedBodyIsTheSameToTheBit) {
  SceneDesc coarse = pressed_block();
  coarse.soft[0].refinement.at = Refining::none;
  Simulation with(pressed_block(), halved()), without(coarse, halved());
  for (int tick = 0; tick < 30; ++tick) {
    with.step(press_at(0, -0.01));
    without.step(press_at(0, -0.01));
  }
  EXPECT_EQ(with.soft_state(pressed).motion.x, without.soft_state(pressed).motion.x);
  EXPECT_EQ(tet_count(with), tet_count(without));
}

// The drawn and touched surface is where it was: it hangs on parts of what it hung on.
TEST(Refine, MovesNothingWhenItComes) {
  Simulation simulation(pressed_block(), halved());
  const auto surface = [&] {
    std::vector<Vec3> out;
    const Anatomy& anatomy = simulation.soft(pressed).anatomy();
    for (std::size_t v = 0; v < anatomy.embedding.rows.size(); ++v)
      out.push_back(anatomy.embedding.apply(v, simulation.soft_state(pressed).motion.x.data()));
    return out;
  };
  const auto rest = [&] {
    double farthest = 0;
    const Anatomy& anatomy = simulation.soft(pressed).anatomy();
    for (std::size_t v = 0; v < anatomy.embedding.rows.size(); ++v)
      farthest = std::max(farthest, (anatomy.embedding.apply(v, simulation.soft(pressed).rest().data()) -
                                     anatomy.surface.positions[v])
                                        .norm());
    return farthest;
  };
  SceneDesc coarse = pressed_block();
  coarse.soft[0].refinement.at = Refining::none;
  Simulation twin(coarse, halved());
  const std::size_t tets = tet_count(simulation);
  for (int tick = 0; tick < 60 && tet_count(simulation) == tets; ++tick) {
    simulation.step(input_at(tick));
    twin.step(input_at(tick));
  }
  ASSERT_GT(tet_count(simulation), tets);
  EXPECT_LT(rest(), 1e-15);
  const Anatomy& whole = twin.soft(pressed).anatomy();
  const std::vector<Vec3> now = surface();
  for (std::size_t v = 0; v < now.size(); ++v)
    EXPECT_LT((now[v] - whole.embedding.apply(v, twin.soft_state(pressed).motion.x.data())).norm(), 1e-15);
}

struct Rung {
  const char *model, *integrator;
};

class RefinedRungs : public ::testing::TestWithParam<Rung> {};

TEST_P(RefinedRungs, SameHashForAnyThreadCountAndAfterARestore) {
  const SceneDesc scene = pressed_block(GetParam().model, GetParam().integrator);
  Simulation one(scene, halved(1)), two(scene, halved(2));
  const std::size_t tets = tet_count(one);
  for (const auto& [from, to] : {std::pair(0, 15), {15, 45}, {45, 90}, {90, 128}}) {
    const auto expected = hashes(one, from, to);
    ASSERT_EQ(hashes(two, from, to), expected);
    const auto saved = one.checkpoint();
    ASSERT_EQ(two.checkpoint(), saved);
    Simulation restored(scene, halved());
    restored.restore(saved);
    ASSERT_EQ(restored.state_hash(), one.state_hash());
    ASSERT_EQ(tet_count(restored), tet_count(one));
    if (to == 45) {
      EXPECT_GT(tet_count(one), tets);
    }
    Simulation through(scene, halved());  // the way on from there
    through.restore(saved);
    ASSERT_EQ(hashes(restored, to, to + 12), hashes(through, to, to + 12));
    two.restore(saved);
  }
  hashes(one, 128, 170);
  EXPECT_EQ(tet_count(one), tets);
}

INSTANTIATE_TEST_SUITE_P(Refine, RefinedRungs,
                         ::testing::Values(Rung{"fem_corotational", "implicit_euler"},
                                           Rung{"fem_neo_hookean", "bdf2"}, Rung{"mass_spring", "tr_bdf2"},
                                           Rung{"fem_corotational", "symplectic_euler"},
                                           Rung{"xpbd", "implicit_euler"}),
                         [](const auto& row) {
                           return std::string(row.param.model) + "_" + row.param.integrator;
                         });

// A run that was saved and one that wasn't go on alike; and back from a refined state to one that isn't.
TEST(Refine, ARestoredRunEqualsTheOneThatWentOn) {
  Simulation through(pressed_block(), halved());
  const auto begin = through.checkpoint();
  run_to(through, 0, 35);
  const auto middle = through.checkpoint();
  const auto expected = hashes(through, 35, 70);
  through.restore(begin);
  EXPECT_EQ(tet_count(through), tet_count(Simulation(pressed_block(), halved())));
  through.restore(middle);
  EXPECT_EQ(hashes(through, 35, 70), expected);
}

TEST(Refine, BrokenCheckpointsAreRefusedAndChangeNothing) {
  Simulation simulation(pressed_block(), halved());
  run_to(simulation, 0, 40);
  const auto good = simulation.checkpoint();
  const std::uint64_t before = simulation.state_hash();
  for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 100)
    EXPECT_THROW(simulation.restore(std::span(good).first(size)), InputError);
  EXPECT_EQ(simulation.state_hash(), before);
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    auto bad = good;
    const std::size_t among = i % 2 == 0 ? bad.size() : 2000;  // what is refined stands at the beginning
    for (int k = 0; k < 3; ++k) bad[60 + random() % (among - 60)] = static_cast<std::uint8_t>(random());
    try {
      simulation.restore(bad);
      simulation.step({});
    } catch (const InputError&) {
    }
  }
  simulation.restore(good);
  EXPECT_EQ(simulation.state_hash(), before);
}

// Whatever pokes it wherever: the same for two threads, and in the end nothing is left of it.
TEST(Refine, RandomPokesLeaveNoTrace) {
  Simulation one(pressed_block(), halved(1)), two(pressed_block(), halved(2));
  const std::uint64_t mesh = one.soft(pressed).content_hash();
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-0.05, 0.05), deep(-0.01, 0.006);
  std::size_t most = 0;
  Vec3 from(0, -0.02, 0);
  for (int poke = 0; poke < 12; ++poke) {
    const Vec3 to(place(random), deep(random), place(random));
    for (int tick = 1; tick <= 12; ++tick) {
      const Vec3 now = from + tick / 12.0 * (to - from);
      for (Simulation* simulation : {&one, &two}) simulation->step(press_at(now.x(), now.y(), now.z()));
    }
    ASSERT_EQ(one.state_hash(), two.state_hash());
    most = std::max(most, tet_count(one));
    if (poke == 6) two.restore(one.checkpoint());
    from = to;
  }
  EXPECT_GT(most, tet_count(one) / 2);
  for (int tick = 0; tick < 200; ++tick) one.step(press_at(0, -0.05));
  EXPECT_EQ(one.soft(pressed).content_hash(), mesh);
  EXPECT_EQ(one.soft(pressed).elements(), Simulation(pressed_block(), halved()).soft(pressed).elements());
}

TEST(Refine, AHandThatHoldsTissueHasItFine) {
  SceneDesc scene = pressed_block();
  Simulation simulation(scene, halved());
  const std::size_t tets = tet_count(simulation);
  const Vec3 at(0, 0.07, 0);
  simulation.step(appear(at));
  simulation.step(event(HandEvent::Kind::grasp, at));
  ASSERT_EQ(simulation.hands()[0].holding, std::optional<BodyId>(pressed));
  for (int tick = 0; tick < 100; ++tick) simulation.step(target(at));
  EXPECT_GT(tet_count(simulation), tets);
  TickInput gone;
  gone.events = {{HandEvent::Kind::vanish, somebody, right_hand, 0}};
  simulation.step(gone);
  for (int tick = 0; tick < 100; ++tick) simulation.step({});
  EXPECT_EQ(tet_count(simulation), tets);
}

/// The block that is cut, and may be refined; with a ball to press it, as body 1.
SceneDesc refinable_and_scalpel() {
  SceneDesc scene = block_and_scalpel();
  scene.rigid.push_back(part_body("ball", "sphere", {2 * ball_radius, 0, 0}, {0, 0.1, 0}));
  scene.rigid[1].fixed = true;
  scene.soft[0].refinement.at = Refining::touch;
  return scene;
}

TickInput with_ball(TickInput input, double depth) {
  input.kinematic_targets.push_back({1, {{0.02, 0.06 + ball_radius - depth, 0.02}, Quat::Identity()}});
  return input;
}

TEST(Refine, ACutTakesItBackFirstAndIsUndone) {
  Simulation simulation(refinable_and_scalpel(), halved());
  constexpr BodyId cut = 2;
  const std::uint64_t mesh = simulation.soft(cut).content_hash();
  const std::size_t tets = tet_count(simulation);
  Vec3 at = take(simulation);
  for (int tick = 0; tick < 30; ++tick) simulation.step(with_ball(target(at), 0.003));
  ASSERT_GT(tet_count(simulation), tets);
  std::uint32_t revision = 0;
  const auto refined =
      std::make_shared<const std::vector<std::uint8_t>>(simulation.checkpoint());  // to rewind to
  const std::size_t then = tet_count(simulation);
  for (int tick = 0; tick < 60; ++tick) {
    at.x() += 0.0016;
    for (const TopologyChange& change : simulation.step(with_ball(target(at), 0.003)).topology)
      revision = change.revision;
  }
  EXPECT_GT(revision, 1u);
  Simulation restored(refinable_and_scalpel(), halved());
  restored.restore(*refined);
  EXPECT_EQ(tet_count(restored), then);
  restored.restore(simulation.checkpoint());
  EXPECT_EQ(restored.state_hash(), simulation.state_hash());

  while (simulation.revision(cut) > 0 && simulation.soft(cut).content_hash() != mesh) {
    const StepReport& report = simulation.step(undo());
    ASSERT_FALSE(report.cut_answers.front()) << report.cut_answers.front().why();
  }
  EXPECT_EQ(simulation.soft(cut).content_hash(), mesh);

  TickInput back;
  back.cuts = {{CutEvent::Kind::rewind, somebody, 0, 0, refined}};
  const StepReport& report = simulation.step(back);
  ASSERT_FALSE(report.cut_answers.front()) << report.cut_answers.front().why();
  EXPECT_EQ(simulation.soft(cut).content_hash(), mesh);  // what was ever cut is refined no more
  restored.restore(simulation.checkpoint());
  EXPECT_EQ(restored.state_hash(), simulation.state_hash());
}

/// The block with a notch in its top, in which a blade touches nothing.
CompileOptions notched() {
  CompileOptions out = options();
  out.anatomy = [](const SoftDesc&) {
    Anatomy anatomy =
        make_block({0.1, 0.06, 0.1}, {5, 3, 5}, [](int i, int j, int) { return i < 2 && j == 2; });
    for (auto* points : {&anatomy.tets.positions, &anatomy.surface.positions})
      for (Vec3& x : *points) x.y() += 0.03;
    halve_surface(anatomy);
    return anatomy;
  };
  return out;
}

TEST(Refine, ABladeThatOnlyCameNearDoesNotEndIt) {
  Simulation simulation(refinable_and_scalpel(), notched());
  const std::size_t tets = tet_count(simulation);
  take(simulation);
  const auto go = [&](const Vec3& at) {
    for (int tick = 0; tick < 30; ++tick) simulation.step(with_ball(target(at), 0.003));
  };
  go({-0.12, 0.25, 0.02});
  ASSERT_GT(tet_count(simulation), tets);
  go({-0.03, 0.25, 0.02});
  go({-0.03, 0.2, 0.02});  // its tip is in the notch
  EXPECT_EQ(tet_count(simulation), tets);
  go({-0.03, 0.3, 0.02});
  EXPECT_GT(tet_count(simulation), tets);
  EXPECT_EQ(simulation.revision(2), 0u);
}

TEST(Refine, WhatCannotBeRefinedIsRefused) {
  SceneDesc scene = pressed_block();
  scene.soft[0].configuration.element = "tet10";
  EXPECT_THROW(Simulation(scene, options()), InputError);
}

}  // namespace
}  // namespace prosector::test
