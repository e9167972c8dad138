// A scene's state, taken over into the same scene with some bodies modelled in another way.

#include <gtest/gtest.h>

#include "server/physics/stations/save/take_over.h"
#include "tests/physics/scalpel.h"

namespace prosector::test {
namespace {

constexpr BodyId first = 2, second = 3;

/// A table, a ball that rolls, a block that is pressed down by its weight, and one that stands beside it.
SceneDesc two_blocks(const std::string& element = "tet4", double cell = 0.03) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("ball", "sphere", {0.03, 0, 0}, {0.6, 0.1, 0})};
  scene.soft = {block("first"), block("second")};
  scene.soft[0].configuration.element = element;
  scene.soft[0].geometry.cell = cell;
  scene.soft[1].pose.p = {0.3, 0, 0};
  scene.soft[0].attach = {{{0, 0, 0}, 0.06, 1e7}};
  return scene;
}

TickInput vanish() {
  TickInput input;
  input.events = {{HandEvent::Kind::vanish, somebody, right_hand, BodyId{0}}};
  return input;
}

/// m: how far the places of the tissue are from each other, by where they are at rest.
double difference(const Simulation& a, const Simulation& b, BodyId body) {
  double worst = 0;
  const VecX &rest = a.soft(body).rest(), &other = b.soft(body).rest();
  for (Eigen::Index i = 0; i < a.soft(body).nodes(); ++i)
    for (Eigen::Index k = 0; k < b.soft(body).nodes(); ++k)
      if ((rest.segment<3>(3 * i) - other.segment<3>(3 * k)).norm() < 1e-9)
        worst = std::max(worst, (a.soft_state(body).motion.x.segment<3>(3 * i) -
                                 b.soft_state(body).motion.x.segment<3>(3 * k))
                                    .norm());
  return worst;
}

Vec3 momentum(const Simulation& simulation, BodyId body) {
  Vec3 sum = Vec3::Zero();
  const VecX& mass = simulation.soft(body).node_mass();
  for (Eigen::Index i = 0; i < mass.size(); ++i)
    sum += mass[i] * simulation.soft_state(body).motion.v.segment<3>(3 * i);
  return sum;
}

TEST(TakeOver, BodiesThatAreModelledAlikeKeepEveryBit) {
  Simulation from(two_blocks(), options()), to(two_blocks(), options());
  run(from, 40);
  from.checkpoint();
  ASSERT_FALSE(to.take_over(from));
  EXPECT_EQ(to.state_hash(), from.state_hash());
  run(from, 30);
  run(to, 30);
  EXPECT_EQ(to.state_hash(), from.state_hash());
}

TEST(TakeOver, ARemodelledBodyKeepsItsShapeAndMotion) {
  for (const auto& [element, cell] : {std::pair{"tet10", 0.03}, std::pair{"tet4", 0.015}}) {
    Simulation from(two_blocks(), options()), to(two_blocks(element, cell), options());
    const VecX at_rest = from.soft_state(first).motion.x;
    from.step(appear({0.01, 0.12, 0.045}));
    for (int i = 0; i < 50; ++i) from.step(target({0.01, 0.12 - 0.001 * i, 0.045}));
    const double pressed = (from.soft_state(first).motion.x - at_rest).lpNorm<Eigen::Infinity>();
    ASSERT_GT(pressed, 5e-3);
    const Vec3 before = momentum(from, first);
    const VecX other = from.soft_state(second).motion.x;
    ASSERT_FALSE(to.take_over(from)) << element;
    EXPECT_EQ(to.time().tick, from.time().tick);
    // Both equilibria are of their own mesh: that much the shapes differ by.
    Simulation fresh(two_blocks(), options()), fresh_other(two_blocks(element, cell), options());
    EXPECT_LT(difference(to, from, first), difference(fresh_other, fresh, first) + 1e-9) << element;
    EXPECT_LT((momentum(to, first) - before).norm(), 0.1 * before.norm() + 1e-9) << element;
    EXPECT_EQ(to.soft_state(second).motion.x, other) << "who is modelled alike";
    EXPECT_TRUE(to.hands().empty());
    EXPECT_FALSE(to.asleep(first));
    from.step(vanish());
    run(from, 300);
    run(to, 300);
    EXPECT_LT(to.max_displacement(first), 1.5 * from.max_displacement(first) + 1e-5)
        << element << " comes back as the old one does";
    EXPECT_LT(to.max_displacement(first), 0.05 * pressed) << element;
  }
}

TEST(TakeOver, WhatNobodyTouchedRestsInTheOtherModelToo) {
  Simulation from(two_blocks(), options()), to(two_blocks("tet10"), options());
  run(from, 5);
  ASSERT_TRUE(from.asleep(first));
  ASSERT_FALSE(to.take_over(from));
  EXPECT_TRUE(to.asleep(first));
  EXPECT_EQ(to.max_displacement(first), 0);
}

/// Whenever it takes over: before, while and after a hand presses.
TEST(TakeOver, GoesOnAsOneThatRestoresIt) {
  Simulation from(two_blocks(), options()), restored(two_blocks("tet10"), options());
  for (int tick = 0; tick < 240; ++tick) {
    const Vec3 at(0.01, 0.14 - 0.001 * std::min(tick, 70), 0.045);
    from.step(tick == 0 ? appear(at) : tick < 120 ? target(at) : tick == 120 ? vanish() : TickInput{});
    if (tick % 17 != 0) continue;
    Simulation to(two_blocks("tet10"), options());
    ASSERT_FALSE(to.take_over(from));
    restored.restore(to.checkpoint());
    ASSERT_EQ(restored.state_hash(), to.state_hash()) << tick;
    for (int later = 0; later < 3; ++later) {
      to.step({});
      restored.step({});
      ASSERT_EQ(restored.state_hash(), to.state_hash()) << tick << " + " << later;
    }
  }
}

TEST(TakeOver, OtherBodiesAreRefused) {
  SceneDesc another = two_blocks();
  another.soft[1].name = "third";
  Simulation from(two_blocks(), options()), to(another, options());
  const std::uint64_t before = to.state_hash();
  EXPECT_EQ(to.take_over(from).why(),
            "the state cannot be transferred: the two scenes do not have the same bodies");
  EXPECT_EQ(to.state_hash(), before);
}

/// The block that is cut, and a second one that the scalpel doesn't reach.
SceneDesc cut_and_whole(const std::string& cut_element, const std::string& whole_element) {
  SceneDesc scene = block_and_scalpel();
  scene.soft.push_back(block("whole"));
  scene.soft[1].pose.p = {0.4, 0, 0};
  scene.soft[1].attach = {{{0.4, 0, 0}, 0.2, 1e7}};
  scene.soft[0].configuration.element = cut_element;
  scene.soft[1].configuration.element = whole_element;
  return scene;
}

TEST(TakeOver, WhatIsCutIsNotRemodelledAndCutsOfOthersStay) {
  Simulation from(cut_and_whole("tet4", "tet4"), options());
  Vec3 at = take(from);
  ASSERT_FALSE(draw(from, at, 60).empty());
  const BodyId cut = 1;
  Simulation refused(cut_and_whole("tet10", "tet4"), options());
  const std::uint64_t before = refused.state_hash();
  EXPECT_EQ(refused.take_over(from).why(), cut_stays("block").why());
  EXPECT_EQ(refused.state_hash(), before);

  Simulation taken(cut_and_whole("tet4", "tet10"), options());
  {
    const Refusal why = taken.take_over(from);
    ASSERT_FALSE(why) << why.why();
  }
  EXPECT_EQ(taken.body_count(), from.body_count());
  EXPECT_EQ(taken.revision(cut), from.revision(cut));
  EXPECT_EQ(taken.soft(cut).content_hash(), from.soft(cut).content_hash());
  EXPECT_EQ(taken.soft_state(cut).motion.x, from.soft_state(cut).motion.x);
  taken.step(undo());
  EXPECT_GT(taken.revision(cut), from.revision(cut)) << "cuts can be taken back";
  run(taken, 30);
}

}  // namespace
}  // namespace prosector::test
