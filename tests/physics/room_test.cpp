// The room around a scene: what falls rests on its floor, what flies stops at its walls, and what leaves it
// all the same comes back once.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "common/room.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/mechanics/soft/unfold.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

/// Returns the saved state without the hash of its scene, which follows the format's number.
std::vector<std::uint8_t> state_of(const Simulation& simulation) {
  std::vector<std::uint8_t> out = simulation.save();
  const auto hash = out.begin() + sizeof(std::uint64_t);
  out.erase(hash, hash + sizeof(ContentHash));
  return out;
}

SceneDesc in_room(bool floor = true, bool walls = true) {
  SceneDesc scene;
  scene.room = RoomDesc{floor, walls};
  return scene;
}

struct BodyNote {
  std::string body, note;
  std::uint64_t tick;
};

/// What a run tells of bodies that were put back.
std::vector<BodyNote> run_and_listen(Simulation& simulation, int ticks, const TickInput& input = {}) {
  std::vector<BodyNote> out;
  TickInput now = input;
  for (int i = 0; i < ticks; ++i) {
    for (const BodyReport& row : simulation.step(now).bodies)
      if (row.reset) out.push_back({row.body, row.note, simulation.time().tick});
    now.events.clear();
  }
  return out;
}

/// Of a soft body's nodes along an axis.
std::pair<double, double> extent(const Simulation& simulation, BodyId body, int axis) {
  const VecX& x = simulation.soft_state(body).motion.x;
  const auto row = x.reshaped(3, x.size() / 3).row(axis);
  return {row.minCoeff(), row.maxCoeff()};
}

std::vector<RigidDesc> one_of_each_shape(double y) {
  std::vector<RigidDesc> out;
  int k = 0;
  for (const char* shape : {"sphere", "box", "capsule", "cylinder", "ellipsoid"})
    out.push_back(part_body(shape, shape, {0.06, 0.06, 0.06}, {0.3 * ++k, y, 0}));
  for (const Fidelity collision : {Fidelity::mesh, Fidelity::sphere, Fidelity::obb}) {
    out.push_back(
        part_body(std::string(fidelity_name(collision)), "box", {0.06, 0.06, 0.06}, {0.3 * ++k, y, 0}));
    out.back().contact.collision = collision;
    std::vector<PartDesc>& parts = out.back().geometry.parts;
    parts.push_back(parts.front());
    parts.back().pose.p.x() = 0.06;
  }
  for (const Fidelity collision : {Fidelity::mesh, Fidelity::hull}) {  // a ring of triangles
    RigidDesc ring;
    ring.name = fmt::format("ring {}", fidelity_name(collision));
    ring.contact.collision = collision;
    CurveDesc curve;
    curve.kind = "ellipse";
    curve.diameter = 0.02;
    ring.geometry.curves = {curve};
    ring.pose.p = {0.3 * ++k - 3, y, 0};
    out.push_back(ring);
  }
  return out;
}

TEST(Room, RigidBodiesOfEveryShapeRestOnTheFloor) {
  SceneDesc scene = in_room();
  scene.rigid = one_of_each_shape(0.3);
  Simulation simulation(scene, options());
  EXPECT_TRUE(run_and_listen(simulation, 300).empty());
  for (BodyId body = 0; body < scene.rigid.size(); ++body) {
    const RigidBodyState state = simulation.rigid_state(body);
    EXPECT_LT(state.linear_velocity.norm(), 0.02) << simulation.name(body);
    const double lowest = !scene.rigid[body].geometry.curves.empty()                ? 0.01  // it lies flat
                          : scene.rigid[body].contact.collision == Fidelity::sphere ? 0.05
                                                                                    : 0.03;
    EXPECT_GT(state.pose.p.y(), lowest - 0.002) << simulation.name(body);
    EXPECT_LT(state.pose.p.y(), 0.08) << simulation.name(body);
  }
}

// A mesh of Bullet's rocks on what it lies on for ever, by itself.
TEST(Room, RigidBodiesOfEveryShapeFallAsleepOnTheFloor) {
  SceneDesc scene = in_room();
  scene.rigid = one_of_each_shape(0.3);
  Simulation simulation(scene, options());
  for (int tick = 0; tick < 600; ++tick) simulation.step({});
  for (BodyId body = 0; body < scene.rigid.size(); ++body)
    EXPECT_TRUE(simulation.asleep(body)) << simulation.name(body);
}

// 17 m/s when they meet: 0.28 m a tick, many times their size.
TEST(Room, WallsStopWhatIsFast) {
  for (const Vec3& way : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    SceneDesc scene = in_room();
    scene.gravity = 40 * way;
    scene.rigid = {part_body("ball", "sphere", {0.05, 0, 0}, {0, 1, 0}),
                   part_body("box", "box", {0.05, 0.05, 0.05}, {0, 2, 0})};
    Simulation simulation(scene, options());
    EXPECT_TRUE(run_and_listen(simulation, 300).empty());
    for (BodyId body = 0; body < 2; ++body)
      EXPECT_NEAR(simulation.rigid_state(body).pose.p.dot(way), RoomShape().width / 2 - 0.025, 0.01)
          << way.transpose();
  }
}

TEST(Room, TissueOfEveryFidelityRestsOnTheFloor) {
  for (const Fidelity collision :
       {Fidelity::mesh, Fidelity::sphere, Fidelity::aabb, Fidelity::obb, Fidelity::hull}) {
    SceneDesc scene = in_room();
    scene.soft = {block()};
    scene.soft[0].pose.p.y() = 0.1;
    scene.soft[0].contact.collision = collision;
    Simulation simulation(scene, options());
    EXPECT_TRUE(run_and_listen(simulation, 240).empty()) << fidelity_name(collision);
    const auto [lowest, highest] = extent(simulation, 0, 1);
    EXPECT_GT(lowest, -0.002) << fidelity_name(collision);
    EXPECT_LT(lowest, collision == Fidelity::sphere ? 0.06 : 0.002) << fidelity_name(collision);
    EXPECT_GT(highest - lowest, 0.04) << fidelity_name(collision);
  }
}

TEST(Room, SheetsRopesAndPositionBasedTissueRestOnTheFloor) {
  for (const char* shape : {"sheet", "rope", "block"}) {
    SceneDesc scene = in_room();
    SoftDesc soft = block(shape);
    soft.geometry.shape = shape;
    soft.configuration.model = "xpbd";
    if (soft.geometry.is_sheet()) soft.geometry.size = {0.1, 0.002, 0.1};
    if (soft.geometry.is_rope()) soft.geometry.size = {0.2, 0.006, 0.006};
    soft.pose.p.y() = 0.06;
    scene.soft = {soft};
    Simulation simulation(scene, options());
    EXPECT_TRUE(run_and_listen(simulation, 240).empty()) << shape;
    const auto [lowest, highest] = extent(simulation, 0, 1);
    EXPECT_GT(lowest, -0.002) << shape;
    EXPECT_LT(lowest, 0.006) << shape;
  }
}

TEST(Room, TissueThatIsFastStopsAtTheWall) {
  SceneDesc scene = in_room();
  scene.gravity = {60, 0, 0};
  scene.soft = {block()};
  scene.soft[0].pose.p = {2, 1, 0};
  Simulation simulation(scene, options());
  for (const BodyNote& report : run_and_listen(simulation, 200))
    EXPECT_EQ(report.note.find("room"), std::string::npos) << report.note;
  EXPECT_LT(extent(simulation, 0, 0).second, RoomShape().width / 2 + 0.01);
  EXPECT_GT(extent(simulation, 0, 0).first, RoomShape().width / 2 - 0.12);
  // What so hard a blow turned inside out is whole again.
  EXPECT_EQ(soft::inverted_share(simulation.soft(0).linear_tets(), simulation.soft_state(0).motion.x), 0);
  EXPECT_GT(soft::volume_share(simulation.soft(0).linear_tets(), simulation.soft_state(0).motion.x), 0.7);
}

// Tissue that starts on the floor is compiled at rest on it, and sleeps.
TEST(Room, TissueBeginsAtRestOnTheFloor) {
  SceneDesc scene = in_room();
  scene.soft = {block()};
  Simulation simulation(scene, options());
  EXPECT_TRUE(simulation.asleep(0));
  const double sagged = extent(simulation, 0, 1).second;
  run(simulation, 60);
  EXPECT_EQ(extent(simulation, 0, 1).second, sagged);
  EXPECT_LT(sagged, 0.06);
  EXPECT_GT(extent(simulation, 0, 1).first, -0.001);
  SceneDesc without = scene;
  without.room = RoomDesc{false, true};
  EXPECT_NE(Simulation(without, options()).content_hash(), simulation.content_hash());
}

TEST(Room, HandsPassWhatTheyHoldDoesNot) {
  SceneDesc scene = in_room();
  scene.rigid = {part_body("stick", "box", {0.04, 0.04, 0.2}, {0, 0.5, 0}, 300)};
  scene.rigid[0].balanced = true;
  Simulation simulation(scene, options());
  const Vec3 start(0, 0.532, 0.06);
  run(simulation, 10, appear(start));
  simulation.step(event(HandEvent::Kind::grasp, start));
  ASSERT_TRUE(simulation.hands()[0].holding);
  double lowest = 1;
  for (int i = 0; i < 120; ++i) {
    simulation.step(target(start - Vec3(0, std::min(0.01 * i, 0.7), 0)));
    lowest = std::min(lowest, simulation.rigid_state(0).pose.p.y());
  }
  EXPECT_GT(lowest, 0.015) << "the stick went through the floor";
  EXPECT_LT(simulation.hands()[0].pose.p.y(), 0.1);
  simulation.step(event(HandEvent::Kind::release, {0, -0.3, 0}));
  run(simulation, 60, target({1, 0.3, 0}));
  run(simulation, 60, target({1, -0.3, 0}));
  EXPECT_LT(simulation.hands()[0].pose.p.y(), -0.25) << "the floor stopped a hand";
}

// What meets no side of the room moves to the bit as it does without one.
TEST(Room, ChangesNothingWhereNothingMeetsIt) {
  SceneDesc scene;
  const Vec3 up(0, 1, 0);
  scene.rigid = {table(), part_body("ball", "sphere", {0.03, 0, 0}, {0.02, 0.1, 0}),
                 part_body("a", "box", {0.05, 0.05, 0.05}, {0.3, 0.1, 0}),
                 part_body("b", "box", {0.05, 0.05, 0.05}, {0.31, 0.16, 0.01})};
  for (int i = 0; i < 60; ++i)
    scene.rigid.push_back(part_body("box" + std::to_string(i), "box", {0.04, 0.04, 0.04},
                                    {-0.5 + 0.05 * (i % 4) + 0.001 * i, 0.05 + 0.05 * (i / 4), -0.4}));
  scene.soft = {block()};
  for (RigidDesc& body : scene.rigid) body.pose.p += up;
  scene.soft[0].pose.p += up;
  SceneDesc with_room = scene;
  with_room.room.emplace();
  Simulation without(scene, options()), with(with_room, options());
  const auto input = [&](int i) {
    const Vec3 at = up + Vec3(0.01, 0.12 - 0.001 * std::min(i, 60), 0.045);
    return i == 0    ? appear(at)
           : i == 70 ? event(HandEvent::Kind::grasp, at)
                     : target(at, Quat::Identity(), 0.01 * std::min(i, 50));
  };
  for (int i = 0; i < 150; ++i) {
    if (i == 100) {
      without.checkpoint();
      with.checkpoint();
    }
    without.step(input(i));
    with.step(input(i));
    ASSERT_EQ(state_of(with), state_of(without)) << "tick " << i;
  }
}

// A bar around the origin, held at one end, hangs as if there were no floor; so does what is held to nothing
// fall.
TEST(Room, WhatBeginsBehindASidePassesThroughIt) {
  SceneDesc scene;
  scene.soft = {block("bar")};
  scene.soft[0].pose.p.setZero();
  scene.soft[0].attach = {{{-0.05, 0, 0}, 0.045, 1e9}};
  scene.rigid = {part_body("ball", "sphere", {0.05, 0, 0}, {1, 0, 0}),
                 part_body("box", "box", {0.05, 0.05, 0.05}, {RoomShape().width / 2, 1, 0})};
  SceneDesc with_room = scene;
  with_room.room.emplace();
  std::vector<std::string> said;
  CompileOptions listening = options();
  listening.progress = [&](const std::string& line) { said.push_back(line); };
  Simulation without(scene, options()), with(with_room, listening);
  for (const char* words :
       {"bar: the body starts behind the room's floor", "ball: the body starts behind the room's floor",
        "box: the body starts behind the room's wall"})
    EXPECT_TRUE(std::any_of(said.begin(), said.end(), [&](const std::string& line) {
      return line.find(words) != std::string::npos;
    })) << words;
  run(without, 20);
  run(with, 20);
  EXPECT_EQ(state_of(with), state_of(without));
  EXPECT_LT(extent(with, 2, 1).first, -0.03);
}

SceneDesc without_floor() {
  SceneDesc scene = in_room(false);
  scene.rigid = {part_body("ball", "sphere", {0.05, 0, 0}, {0, 1, 0})};
  scene.soft = {block()};
  scene.soft[0].pose.p = {0.5, 1, 0};
  return scene;
}

TEST(Room, WhatIsLostComesBackOnceAndIsSaidOnce) {
  Simulation simulation(without_floor(), options());
  std::vector<BodyNote> reports = run_and_listen(simulation, 60);
  EXPECT_TRUE(reports.empty()) << "lost within a second";
  EXPECT_LT(simulation.rigid_state(0).pose.p.y(), -1);
  reports = run_and_listen(simulation, 600);
  ASSERT_EQ(reports.size(), 4u);
  for (const char* body : {"ball", "block"}) {
    std::vector<BodyNote> own;
    std::copy_if(reports.begin(), reports.end(), std::back_inserter(own),
                 [&](const BodyNote& t) { return t.body == body; });
    ASSERT_EQ(own.size(), 2u) << body;
    EXPECT_NE(own[0].note.find("left the room: moved back to its initial position"), std::string::npos)
        << own[0].note;
    EXPECT_NE(own[1].note.find("it rests there"), std::string::npos) << own[1].note;
  }
  for (BodyId body = 0; body < 2; ++body) EXPECT_TRUE(simulation.asleep(body));
  EXPECT_NEAR(simulation.rigid_state(0).pose.p.y(), 1, 1e-6);
  EXPECT_NEAR(extent(simulation, 1, 1).first, 0.97, 1e-6);
}

// Whoever holds what was lost makes it a new matter.
TEST(Room, WhatSomebodyTakesAndDropsMayBeLostAnew) {
  Simulation simulation(without_floor(), options());
  EXPECT_EQ(run_and_listen(simulation, 600).size(), 4u);
  const Vec3 at(0, 1.037, 0.06);
  simulation.step(appear(at));
  simulation.step(event(HandEvent::Kind::grasp, at));
  ASSERT_TRUE(simulation.hands()[0].holding);
  run(simulation, 5, target(at));
  simulation.step(event(HandEvent::Kind::release, at));
  const std::vector<BodyNote> reports = run_and_listen(simulation, 300, event(HandEvent::Kind::vanish, at));
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_NE(reports[0].note.find("moved back to its initial position"), std::string::npos);
}

TEST(Room, StateHoldsWhatWasLost) {
  Simulation through(without_floor(), options());
  run(through, 150);  // once back, falling again
  const std::vector<std::uint8_t> saved = through.checkpoint();
  Simulation restored(without_floor(), options());
  restored.restore(saved);
  EXPECT_EQ(restored.state_hash(), through.state_hash());
  const std::vector<BodyNote> reports = run_and_listen(restored, 300);
  ASSERT_EQ(reports.size(), 2u) << "both rest where they are";
  run(through, 300);
  EXPECT_EQ(restored.state_hash(), through.state_hash());
}

TEST(Room, WithoutWallsWhatFliesOffComesBack) {
  SceneDesc scene = in_room(true, false);
  scene.gravity = {20, -9.81, 0};
  scene.rigid = {part_body("ball", "sphere", {0.05, 0, 0}, {0, 1, 0})};
  Simulation simulation(scene, options());
  const std::vector<BodyNote> reports = run_and_listen(simulation, 600);
  EXPECT_EQ(reports.size(), 2u);
  EXPECT_NEAR(simulation.rigid_state(0).pose.p.x(), 0, 1e-6);
}

TEST(Room, EmptySpaceHasNoneButAnEnd) {
  SceneDesc scene;
  scene.rigid = {part_body("ball", "sphere", {0.05, 0, 0}, {0, 1, 0})};
  Simulation simulation(scene, options());
  EXPECT_TRUE(run_and_listen(simulation, 600).empty());
  EXPECT_LT(simulation.rigid_state(0).pose.p.y(), -400);
  EXPECT_EQ(run_and_listen(simulation, 1800).size(), 2u);
}

}  // namespace
}  // namespace prosector::test
