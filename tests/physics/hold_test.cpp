// How hands take hold, hold together, and let go.

#include <gtest/gtest.h>

#include <cmath>

#include "common/hand.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

TickInput at(const std::vector<std::pair<ParticipantId, Vec3>>& hands,
             std::optional<HandEvent::Kind> event = {}) {
  TickInput out;
  for (const auto& [who, place] : hands) {
    HandTarget t;
    t.participant = who;
    t.target.p = place;
    out.targets.push_back(t);
    if (event) out.events.push_back({*event, who, right_hand, 0});
  }
  return out;
}

Vec3 middle(const Simulation& simulation, BodyId body) {
  const VecX& x = simulation.soft_state(body).motion.x;
  return x.reshaped(3, x.size() / 3).rowwise().mean();
}

TEST(Hold, TwoHandsPullingApartBalance) {
  for (const bool both : {true, false}) {
    SceneDesc scene;
    scene.gravity = Vec3::Zero();
    scene.soft = {block()};
    scene.soft[0].geometry.size = {0.24, 0.06, 0.1};
    Simulation simulation(scene, options());
    const Vec3 left(-0.08, 0.073, 0.045), right(0.08, 0.073, 0.045);
    simulation.step(at({{1, left}, {2, right}}, HandEvent::Kind::appear));
    simulation.step(at({{1, left}, {2, right}}, HandEvent::Kind::grasp));
    ASSERT_TRUE(simulation.hands()[0].holding && simulation.hands()[1].holding);
    EXPECT_EQ(*simulation.hands()[0].holding, *simulation.hands()[1].holding);
    if (!both) simulation.step(at({{1, left}}, HandEvent::Kind::vanish));
    const double before = middle(simulation, 0).x();
    double settled = before;
    for (int i = 0; i < 120; ++i) {
      const Vec3 pull(0.02 * std::min(1.0, i / 30.0), 0, 0);
      simulation.step(both ? at({{1, left - pull}, {2, right + pull}}) : at({{2, right + pull}}));
      if (i == 90) settled = middle(simulation, 0).x();
    }
    const double moved = middle(simulation, 0).x() - before;
    if (both) {
      EXPECT_LT(std::abs(moved), 0.2 * 0.02);  // two right hands grip a little differently
      EXPECT_LT(std::abs(middle(simulation, 0).x() - settled), 1e-4);
      EXPECT_GT(simulation.max_displacement(0), 0.01);
    } else {
      EXPECT_GT(moved, 0.8 * 0.02);
    }
  }
}

TEST(Hold, TwoHandsLiftWhatOneCannot) {
  for (const bool both : {true, false}) {
    SceneDesc scene;
    scene.rigid = {table(), part_body("weight", "box", {0.3, 0.04, 0.08}, {0, 0.02, 0})};
    scene.rigid[1].material.mass = 6;  // 59 N; a hand pulls with 40 N at most
    Simulation simulation(scene, options());
    std::vector<std::pair<ParticipantId, Vec3>> hands = {{1, {-0.08, 0.055, 0.045}}};
    if (both) hands.push_back({2, {0.08, 0.055, 0.045}});
    run(simulation, 10);
    simulation.step(at(hands, HandEvent::Kind::appear));
    simulation.step(at(hands, HandEvent::Kind::grasp));
    for (const HandState& hand : simulation.hands()) ASSERT_TRUE(hand.holding);
    for (int i = 0; i < 180; ++i) {
      for (auto& [who, place] : hands) place.y() += i < 90 ? 0.2 / 90 : 0;
      simulation.step(at(hands));
    }
    if (both)
      EXPECT_GT(simulation.rigid_state(1).pose.p.y(), 0.15);
    else
      EXPECT_LT(simulation.rigid_state(1).pose.p.y(), 0.1);  // one end at most
  }
}

TEST(Hold, TearsAtTheScenesForce) {
  for (const double tear_force : {10.0, 100.0}) {
    SceneDesc scene;
    scene.hand.tear_force = tear_force;
    scene.soft = {block()};
    scene.soft[0].material.youngs_modulus = 5e4;
    scene.soft[0].attach = {{{0, 0, 0}, 0.06, 1e9}};
    Simulation simulation(scene, options());
    const Vec3 on_top(-0.004, 0.073, 0.045);
    simulation.step(at({{1, on_top}}, HandEvent::Kind::appear));
    simulation.step(at({{1, on_top}}, HandEvent::Kind::grasp));
    ASSERT_TRUE(simulation.hands()[0].holding);
    std::string why;
    for (int i = 0; i < 120; ++i)
      for (const LetGo& let_go : simulation.step(at({{1, on_top + Vec3(0, 0.0005 * i, 0)}})).let_go)
        why = let_go.why;
    EXPECT_EQ(simulation.hands()[0].holding.has_value(), tear_force > 50);
    EXPECT_EQ(why.find("torn") != std::string::npos, tear_force < 50) << why;
  }
}

// A client that stalled sends a hand from one pose to quite another: its ends go along arcs, and the hold
// must not take for a pull what these differ by from straight ways.
TEST(Hold, ASwiftTurnDoesNotTearALightToolAway) {
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  scene.rigid = {part_body("knife", "box", {0.27, 0.004, 0.014}, {0.1, 0, 0}, 3000)};
  Simulation simulation(scene, options());
  const Vec3 place(0, 0.034, 0.045);
  simulation.step(at({{1, place}}, HandEvent::Kind::appear));
  simulation.step(at({{1, place}}, HandEvent::Kind::grasp));
  ASSERT_TRUE(simulation.hands()[0].holding);
  run(simulation, 30, at({{1, place}}));
  for (const double angle : {2.5, -0.5, 2.0}) {
    TickInput turned = at({{1, place}});
    turned.targets[0].target.q = Eigen::AngleAxisd(angle, Vec3(1, 2, 0.5).normalized());
    for (int i = 0; i < 40; ++i)
      for (const LetGo& let_go : simulation.step(turned).let_go) ADD_FAILURE() << let_go.why;
  }
  EXPECT_TRUE(simulation.hands()[0].holding);
}

TEST(Hold, SettingDownLetsGoAndHoldingOnInTheAirDoesNot) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("rod", "box", {0.2, 0.012, 0.012}, {0, 0.006, 0}, 4000)};
  Simulation simulation(scene, options());
  run(simulation, 30);
  const Vec3 low(0, 0.04, 0.045);
  simulation.step(at({{1, low}}, HandEvent::Kind::appear));
  simulation.step(at({{1, low}}, HandEvent::Kind::grasp));
  ASSERT_TRUE(simulation.hands()[0].holding);
  run(simulation, 60, at({{1, low}}));  // it lies there, but nobody set it down
  ASSERT_TRUE(simulation.hands()[0].holding);
  std::string why;
  const auto go = [&](double from, double to) {
    for (int i = 0; i <= 120 && simulation.hands()[0].holding; ++i) {
      const double y = from + (to - from) * std::min(1.0, i / 60.0);
      for (const LetGo& let_go : simulation.step(at({{1, low + Vec3(0, y, 0)}})).let_go) why = let_go.why;
    }
  };
  go(0, 0.1);
  ASSERT_TRUE(simulation.hands()[0].holding) << why;
  EXPECT_GT(simulation.rigid_state(1).pose.p.y(), 0.09);
  go(0.1, 0);
  EXPECT_FALSE(simulation.hands()[0].holding);
  EXPECT_NE(why.find("set down"), std::string::npos) << why;
}

TEST(Hold, OneFingerHoldsNothing) {
  // The index finger stretched, its tip at the ball; the others in a fist, far from it.
  const std::array<double, fingers> pointing{1, 0, 1, 1, 1};
  constexpr std::size_t tip = 4;  // the last joint of the index
  const HandSegment& last = hand_segments(right_hand)[tip];
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  scene.rigid = {part_body("ball", "sphere", {0.02, 0, 0}, {})};
  scene.rigid[0].pose.p =
      hand_pose(right_hand, pointing)[tip] * Vec3(0, 0, -last.length - last.radius - 0.011);
  Simulation simulation(scene, options());
  for (const bool open : {false, true}) {
    TickInput input = at({{1, Vec3::Zero()}}, HandEvent::Kind::appear);
    input.targets[0].flexion = open ? std::array<double, fingers>{} : pointing;
    simulation.step(input);
    input.events.clear();
    run(simulation, 30, input);
    input.events.push_back({HandEvent::Kind::grasp, 1, right_hand, 0});
    simulation.step(input);
    EXPECT_EQ(simulation.hands()[0].holding.has_value(), open);
    input.events[0].kind = HandEvent::Kind::vanish;
    simulation.step(input);
  }
}

}  // namespace
}  // namespace prosector::test
