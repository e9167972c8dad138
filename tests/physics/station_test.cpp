// Stations of a step by themselves, on states that nothing has stepped.

#include <gtest/gtest.h>

#include <optional>

#include "server/physics/mechanics/coupled/vibration.h"
#include "server/physics/stations/compile/compile.h"
#include "server/physics/stations/dissecting/tissue_near.h"
#include "server/physics/stations/hands/hands.h"
#include "server/physics/stations/hands/holding.h"
#include "server/physics/stations/islands/island_builder.h"
#include "server/physics/stations/islands/sleep.h"
#include "server/physics/stations/parts/part_rules.h"
#include "server/physics/stations/save/checkpoint.h"
#include "server/physics/stations/tick_parts.h"
#include "server/physics/stations/touching/fit_tissue.h"
#include "server/physics/stations/touching/soft_contact_finder.h"
#include "tests/physics/scenes.h"

namespace prosector {
namespace {

constexpr double h = 1.0 / 60;

/// A block with a ball beside it, and another block far away.
SceneDesc two_blocks_and_a_ball() {
  SceneDesc scene;
  scene.rigid = {test::part_body("ball", "sphere", Vec3::Constant(0.02), {0, 0.2, 0})};
  scene.soft = {test::block("near"), test::block("far")};
  scene.soft[1].pose.p.x() += 1;
  return scene;
}

/// What a scene is before its first tick, without its equilibrium.
class Stations : public ::testing::Test {
 protected:
  State& begin(const SceneDesc& scene) {
    compiled_.emplace(compile(scene, test::options()));
    state_.emplace(compiled_->model, std::move(compiled_->soft));
    for (Tissue& tissue : state_->bodies.soft) fit_to_mesh(*state_, tissue.index, {});
    return *state_;
  }
  const Colliders& look() {
    refresh(colliders_, state_->bodies, state_->hands, state_->dissection.blades);
    return colliders_;
  }
  /// Puts the scene's first rigid body there.
  void put(const Vec3& at, const Vec3& velocity) {
    rigid::RigidMotion motion = state_->bodies.rigid.motion(0);
    motion.pose.p = at;
    motion.linear_velocity = velocity;
    state_->bodies.rigid.set_motion(0, motion);
  }
  Vec3 top_of_first_block() const {
    const contact::SurfaceDetector& vertices = state_->bodies.soft[0].surface.vertices();
    const Vec3 middle = (vertices.lo() + vertices.hi()) / 2;
    return {middle.x(), vertices.hi().y(), middle.z()};
  }

 private:
  std::optional<CompiledScene> compiled_;
  std::optional<State> state_;
  Colliders colliders_;
};

/// Says of how many ticks the first block is put to rest, if ever, while it shivers by `way` m in what
/// touches it.
std::optional<int> ticks_until_rest(State& state, double way, bool touched) {
  Tissue& block = state.bodies.soft[0];
  block.state.asleep = false;
  const VecX x = block.state.motion.x;
  for (int tick = 1; tick <= 300; ++tick) {
    state.time.tick = static_cast<std::uint64_t>(tick);
    block.state.motion.x = x + VecX::Constant(x.size(), tick % 2 ? way : 0);
    block.state.motion.v = VecX::Constant(x.size(), tick % 2 ? -0.1 : 0.1);
    std::vector<coupled::Island> islands(1);
    islands[0].soft.push_back({0, block.solver.get(), &block.state, &block.equilibrium});
    if (touched) {
      contact::Contact& contact = islands[0].contacts.emplace_back();
      contact.a.kind = contact::ContactSide::Kind::soft;
      contact.a.body = 0;
    }
    update_sleep(state, islands, false);
    if (block.state.asleep) return tick;
  }
  return std::nullopt;
}

TEST_F(Stations, SleepComesToWhatShiversInContactAndNothingElse) {
  const double bound = *coupled::lingering_bound(*begin(two_blocks_and_a_ball()).bodies.soft[0].solver, true);
  const std::optional<int> ticks = ticks_until_rest(begin(two_blocks_and_a_ball()), 0.9 * bound, true);
  ASSERT_TRUE(ticks);
  EXPECT_NEAR(*ticks, 60 + 150, 2) << "it is watched from a whole second on";
  EXPECT_FALSE(ticks_until_rest(begin(two_blocks_and_a_ball()), 1.1 * bound, true));
  EXPECT_FALSE(ticks_until_rest(begin(two_blocks_and_a_ball()), 0.9 * bound, false));
}

TEST_F(Stations, WhatIsThinMayLingerInTheAirButLess) {
  SceneDesc scene = two_blocks_and_a_ball();
  scene.soft[1].geometry.shape = "sheet";
  scene.soft[1].configuration.model = "xpbd";
  scene.soft[1].geometry.size.y() = 0.001;
  const State& state = begin(scene);
  const soft::SoftBody &block = *state.bodies.soft[0].solver, &sheet = *state.bodies.soft[1].solver;
  EXPECT_FALSE(coupled::lingering_bound(block, false));
  EXPECT_NEAR(*coupled::lingering_bound(sheet, true), sheet.desc().geometry.cell, 1e-12);
  EXPECT_NEAR(*coupled::lingering_bound(sheet, false), 0.1 * sheet.desc().geometry.cell, 1e-12);
}

TEST_F(Stations, CheckpointsHoldWhoLingers) {
  State& state = begin(two_blocks_and_a_ball());
  state.lingerers.begin_tick(60);
  state.lingerers.linger({state.bodies.soft_id(0), state.bodies.soft[0].state.motion.x, 1});
  state.lingerers.linger({0, coupled::points_of(Pose{}), 1});
  state.lingerers.end_tick();
  const std::uint64_t hash = hash_of(state);
  ByteWriter out;
  save(state, out);
  state.lingerers.set({});
  EXPECT_EQ(hash_of(state), hash) << "they change nothing in the next tick";
  load(state, out.bytes());
  ASSERT_EQ(state.lingerers.watched().size(), 2u);
  EXPECT_EQ(state.lingerers.watched().begin()->second.place, coupled::points_of(Pose{}));
}

TEST_F(Stations, TheContactFinderWakesOnlyWhatAMovingBallComesTo) {
  State& state = begin(two_blocks_and_a_ball());
  SoftContactFinder finder(state.bodies.soft.size());
  put(top_of_first_block() + Vec3(0, 0.5, 0), {0, -0.1, 0});
  finder.find(state, look(), h);
  EXPECT_TRUE(state.bodies.soft[0].state.asleep);
  EXPECT_TRUE(finder.found().with_rigid[0].empty());

  put(top_of_first_block() + Vec3(0, 0.0105, 0), {0, -0.1, 0});
  const contact::SoftContacts& touching = finder.find(state, look(), h);
  EXPECT_FALSE(state.bodies.soft[0].state.asleep);
  EXPECT_FALSE(touching.with_rigid[0].empty());
  EXPECT_TRUE(state.bodies.soft[1].state.asleep);
  for (const contact::Contact& contact : touching.with_rigid[0]) {
    EXPECT_EQ(contact.a.body, 0U);
    EXPECT_EQ(contact.b.body, 0U);
    EXPECT_LT(contact.normal.y(), 0);  // out of the ball
  }
}

TEST_F(Stations, TheContactFinderGroupsBodiesThatTouchEachOther) {
  SceneDesc scene = two_blocks_and_a_ball();
  scene.soft[1].pose = scene.soft[0].pose;
  scene.soft[1].pose.p.y() += 0.0605;  // on top of it
  State& state = begin(scene);
  for (Tissue& tissue : state.bodies.soft) tissue.wake();
  SoftContactFinder finder(state.bodies.soft.size());
  const contact::SoftContacts& touching = finder.find(state, look(), h);
  ASSERT_EQ(touching.pairs.size(), 1U);
  EXPECT_EQ(touching.pairs[0].a, 0U);
  EXPECT_EQ(touching.pairs[0].b, 1U);
  EXPECT_EQ(touching.group, (std::vector<std::size_t>{0, 0}));
}

TEST_F(Stations, TheIslandBuilderJoinsWhatTouchesAndLeavesSleepersOut) {
  State& state = begin(two_blocks_and_a_ball());
  put(top_of_first_block() + Vec3(0, 0.0105, 0), {0, -0.1, 0});
  const Colliders& colliders = look();
  state.bodies.rigid.detect(h);
  SoftContactFinder finder(state.bodies.soft.size());
  const contact::SoftContacts& touching = finder.find(state, colliders, h);
  const auto& mixed = find_islands(state.bodies, state.hands, {}, touching, {}, h);
  std::vector<coupled::Island> islands;
  std::vector<Pad> pads;
  IslandBuilder(state.bodies, state.hands, {}, touching, colliders, {}, h).build(mixed, islands, pads);
  ASSERT_EQ(islands.size(), 1U);
  ASSERT_EQ(islands[0].soft.size(), 1U);
  EXPECT_EQ(islands[0].soft[0].index, 0U);
  ASSERT_EQ(islands[0].rigid.size(), 1U);
  EXPECT_EQ(islands[0].rigid[0].slot, 0U);
  EXPECT_EQ(islands[0].contacts.size(), touching.with_rigid[0].size());
  EXPECT_TRUE(islands[0].ties.empty());
}

TEST_F(Stations, WhatIsAboutToFallAsleepIsSolvedWithTheTissueThatTouchesIt) {
  State& state = begin(two_blocks_and_a_ball());
  put(top_of_first_block() + Vec3(0, 0.0105, 0), Vec3::Zero());
  state.bodies.rigid.sleep(0, rigid::RigidWorld::Sleep::with_neighbours);
  state.bodies.soft[0].wake();
  const Colliders& colliders = look();
  state.bodies.rigid.detect(h);
  SoftContactFinder finder(state.bodies.soft.size());
  const contact::SoftContacts& touching = finder.find(state, colliders, h);
  ASSERT_FALSE(touching.with_rigid[0].empty());
  const auto& mixed = find_islands(state.bodies, state.hands, {}, touching, {}, h);
  ASSERT_EQ(mixed.size(), 1U);
  EXPECT_EQ(mixed[0].bodies, std::vector<std::size_t>{0});
}

TEST_F(Stations, AHoldPullsByItsSpringUpToItsBound) {
  State& state = begin(two_blocks_and_a_ball());
  appear(state, 1, right_hand);
  hands::Hand& hand = state.hands.front();
  hands::Hold& hold = hand.hold.emplace();
  hold.body = 0;
  hold.points.push_back({Vec3::Zero(), Vec3::Zero(), 0, 100, 1e9});
  const Vec3 apart = state.bodies.rigid.motion(hand.slot).pose.p - state.bodies.rigid.motion(0).pose.p;
  EXPECT_LT((hold_force(state.bodies, hand) - 100 * apart).norm(), 1e-9 * apart.norm());
  hold.points.front().max_force = 0.5;
  EXPECT_LE(hold_force(state.bodies, hand).norm(), 0.5 + 1e-12);
  EXPECT_GT(hold_force(state.bodies, hand).dot(apart), 0);
}

TEST_F(Stations, ATickWithAFastPlateIsTakenInPartsThatEndAtItsTarget) {
  SceneDesc scene = two_blocks_and_a_ball();
  scene.rigid[0] = test::part_body("plate", "box", {0.2, 0.01, 0.2}, {0, 0.2, 0});
  scene.rigid[0].fixed = true;
  State& state = begin(scene);
  Colliders colliders;
  EXPECT_EQ(TickParts(state, colliders).count(), 1);
  const Pose target{top_of_first_block() - Vec3(0, 0.05, 0), Quat::Identity()};
  state.bodies.rigid.drive(0, target, state.bodies.model.h);
  TickParts parts(state, colliders);
  ASSERT_GT(parts.count(), 1);
  EXPECT_NEAR(parts.count() * parts.h(), state.bodies.model.h, 1e-15);
  for (int k = 0; k < parts.count(); ++k) parts.aim(k);
  EXPECT_EQ(state.bodies.rigid.driven_to(0)->p, target.p);
}

TEST_F(Stations, TissueIsFoundAtPointsInsideItOnly) {
  State& state = begin(two_blocks_and_a_ball());
  const Vec3 inside = top_of_first_block() - Vec3(0, 0.03, 0), outside = inside + Vec3(0, 0.06, 0);
  const std::vector<Vec3> points = {inside, outside};
  const std::vector<TissueNear> near = tissue_near(state.bodies, swept_box(points, points));
  ASSERT_EQ(near.size(), 1U);
  const auto found = tissue_at(near, inside);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->body, 0U);
  EXPECT_LT((organs::point_of(found->row, state.bodies.soft[0].state.motion.x) - inside).norm(), 1e-9);
  EXPECT_FALSE(tissue_at(near, outside));
  state.bodies.parts[state.bodies.soft_id(0)].hidden = true;
  EXPECT_TRUE(tissue_near(state.bodies, swept_box(points, points)).empty());
}

TEST_F(Stations, ThePartRulesRefuseWhatIsNoPartAndHideWhatIs) {
  SceneDesc scene = two_blocks_and_a_ball();
  scene.soft[0].part = true;
  State& state = begin(scene);
  state.bodies.soft[0].wake();
  StepReport report;
  PartEvent event;
  event.kind = PartEvent::Kind::hide;
  event.body = state.bodies.soft_id(1);
  EXPECT_TRUE(obey(state, event, report));
  EXPECT_FALSE(state.bodies.parts[event.body].hidden);
  event.body = state.bodies.soft_id(0);
  EXPECT_FALSE(obey(state, event, report));
  EXPECT_TRUE(state.bodies.parts[event.body].out_of_touch());
  EXPECT_TRUE(state.bodies.soft[0].state.asleep);
}

}  // namespace
}  // namespace prosector
