// Parts of the anatomy: taken out of their place and put back, hidden, inspected, made softer or stiffer.

#include <gtest/gtest.h>

#include <cmath>

#include "common/error.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr BodyId bone = 1, organ = 2;

/// A bone that floats in its place, and an organ that is attached beside the table's edge.
SceneDesc anatomy() {
  SceneDesc scene;
  scene.rigid = {table(), part_body("bone", "box", {0.04, 0.04, 0.2}, {0.4, 0.5, 0})};
  scene.rigid[bone].part = true;
  scene.soft = {block("organ")};
  scene.soft[0].pose.p = {0, 0.33, 0};
  scene.soft[0].part = true;
  scene.soft[0].gravity = false;
  scene.soft[0].attach = {{{0, 0.3, 0}, 0.05, 2e7}};
  return scene;
}

TickInput part(PartEvent::Kind kind, BodyId body, double value = 0, const Affine& shape = {}) {
  TickInput out;
  out.parts.push_back({kind, somebody, body, shape, value});
  return out;
}

Vec3 middle(const Simulation& simulation) {
  const VecX& x = simulation.soft_state(organ).motion.x;
  return x.reshaped(3, x.size() / 3).rowwise().mean();
}

std::string answer(Simulation& simulation, const TickInput& input) {
  return simulation.step(input).part_answers.at(0).why();
}

TEST(Part, StaysInItsPlaceUntilDetachedAndFallsThen) {
  Simulation simulation(anatomy(), options());
  run(simulation, 60);
  EXPECT_EQ(simulation.rigid_state(bone).pose.p.y(), 0.5);
  EXPECT_EQ(answer(simulation, part(PartEvent::Kind::detach, bone)), "");
  EXPECT_EQ(answer(simulation, part(PartEvent::Kind::detach, organ)), "");
  EXPECT_FALSE(simulation.part(bone).attached);
  run(simulation, 8);
  // Free fall, by implicit Euler's sums: g·h²·n(n+1)/2, and a little less for damped tissue.
  const double h = 1.0 / 60;
  EXPECT_NEAR(simulation.rigid_state(bone).pose.p.y(), 0.5 - 9.81 * h * h * 10 * 11 / 2, 1e-3);
  EXPECT_LT(middle(simulation).y(), 0.33 - 0.8 * 9.81 * h * h * 9 * 10 / 2);
  run(simulation, 400);
  EXPECT_NEAR(simulation.rigid_state(bone).pose.p.y(), 0.02, 0.003);
  EXPECT_NEAR(middle(simulation).y(), 0.03, 0.005);
}

TEST(Part, SnapsIntoItsPlaceFromNearbyOnly) {
  SceneDesc scene = anatomy();
  scene.gravity = Vec3::Zero();
  Simulation simulation(scene, options());
  const VecX before = simulation.soft_state(organ).motion.x;
  for (const BodyId body : {bone, organ}) {
    const Vec3 place = body == bone ? Vec3(0.4, 0.5, 0) : Vec3(0, 0.33, 0);
    EXPECT_EQ(answer(simulation, part(PartEvent::Kind::detach, body)), "");
    // A hand takes it 10 cm away.
    const Vec3 grip = place + Vec3(0, body == bone ? 0.034 : 0.044, 0.045);
    simulation.step(appear(grip));
    simulation.step(event(HandEvent::Kind::grasp, grip));
    ASSERT_TRUE(simulation.hands()[0].holding);
    ASSERT_EQ(*simulation.hands()[0].holding, body);
    for (int i = 1; i <= 60; ++i) simulation.step(target(grip + Vec3(0.1 * i / 60, 0, 0)));
    run(simulation, 60, target(grip + Vec3(0.1, 0, 0)));
    const std::string far = answer(simulation, part(PartEvent::Kind::attach, body));
    EXPECT_NE(far.find("cm from its original position"), std::string::npos) << far;
    EXPECT_FALSE(simulation.part(body).attached);
    for (int i = 1; i <= 60; ++i) simulation.step(target(grip + Vec3(0.1 - 0.085 * i / 60, 0, 0)));
    run(simulation, 60, target(grip + Vec3(0.015, 0, 0)));
    EXPECT_EQ(answer(simulation, part(PartEvent::Kind::attach, body)), "");
    EXPECT_TRUE(simulation.part(body).attached);
    simulation.step(event(HandEvent::Kind::vanish, grip));
    run(simulation, 300);
  }
  EXPECT_LT((simulation.rigid_state(bone).pose.p - Vec3(0.4, 0.5, 0)).norm(), 1e-6);  // Bullet's floats
  EXPECT_LT((simulation.soft_state(organ).motion.x - before).lpNorm<Eigen::Infinity>(), 5e-4);
}

TEST(Part, OnlyPartsCanBeHadApart) {
  Simulation simulation(anatomy(), options());
  EXPECT_NE(answer(simulation, part(PartEvent::Kind::hide, 0)), "");
  EXPECT_NE(answer(simulation, part(PartEvent::Kind::detach, 99)), "");
  EXPECT_NE(answer(simulation, part(PartEvent::Kind::set_stiffness, bone, 2)), "");
  EXPECT_NE(answer(simulation, part(PartEvent::Kind::set_stiffness, organ, 5)), "");
  EXPECT_NE(answer(simulation, part(PartEvent::Kind::set_opacity, organ, 2)), "");
  Affine nonsense;
  nonsense.A *= std::nan("");
  EXPECT_NE(answer(simulation, part(PartEvent::Kind::inspect, organ, 0, nonsense)), "");
  EXPECT_EQ(simulation.part(organ), Part());
}

TEST(Part, WhatIsHiddenOrInspectedTouchesNothing) {
  for (const PartEvent::Kind kind : {PartEvent::Kind::hide, PartEvent::Kind::inspect}) {
    SceneDesc scene = anatomy();
    scene.rigid.push_back(part_body("ball", "sphere", {0.04, 0, 0}, {0, 0.5, 0}));     // above the organ
    scene.rigid.push_back(part_body("other", "sphere", {0.04, 0, 0}, {0.4, 0.7, 0}));  // above the bone
    Simulation simulation(scene, options());
    const BodyId tissue = 4;
    Affine larger;
    larger.A *= 2;
    EXPECT_EQ(answer(simulation, part(kind, bone, 0, larger)), "");
    EXPECT_EQ(answer(simulation, part(kind, tissue, 0, larger)), "");
    run(simulation, 240);
    EXPECT_LT(simulation.rigid_state(2).pose.p.y(), 0.05);
    EXPECT_LT(simulation.rigid_state(3).pose.p.y(), 0.05);
    EXPECT_EQ(simulation.rigid_state(bone).pose.p.y(), 0.5);
    EXPECT_EQ(simulation.max_displacement(tissue), 0);
    // And does again afterwards.
    const auto back = kind == PartEvent::Kind::hide ? PartEvent::Kind::show : PartEvent::Kind::end_inspect;
    for (const BodyId ball : {2, 3}) {
      TickInput reset;
      reset.events.push_back({HandEvent::Kind::reset_body, 0, 0, ball});
      simulation.step(reset);
    }
    EXPECT_EQ(answer(simulation, part(back, bone)), "");
    EXPECT_EQ(answer(simulation, part(back, tissue)), "");
    run(simulation, 30);
    EXPECT_GT(simulation.rigid_state(2).pose.p.y(), 0.3);
    EXPECT_GT(simulation.rigid_state(3).pose.p.y(), 0.5);
    EXPECT_EQ(simulation.part(bone), Part());
  }
}

/// How far the organ hangs down of its attachment under its own weight, m, per law and stiffness.
double sag(const std::string& model, const std::string& integrator, double stiffness) {
  SceneDesc scene;
  scene.soft = {block("organ")};
  SoftDesc& desc = scene.soft[0];
  desc.part = true;
  desc.configuration.model = model;
  desc.configuration.integrator = integrator;
  desc.pose.p = {0, 0.5, 0};
  desc.material.youngs_modulus = 1e5;
  desc.material.damping_mass = 10;
  desc.attach = {{{0, 0.53, 0}, 0.08, 1e12}};  // as good as clamped, on top
  Simulation simulation(scene, options());
  const auto tip = [&] {
    const VecX& x = simulation.soft_state(0).motion.x;
    double lowest = 1;
    for (Eigen::Index n = 1; n < x.size(); n += 3) lowest = std::min(lowest, x[n]);
    return 0.47 - lowest;
  };
  simulation.step(part(PartEvent::Kind::set_stiffness, 0, stiffness));
  run(simulation, 400);
  return tip();
}

// The attachment's rule is density of stiffness over a ball that reaches into the block, so only the part
// below it hangs: the extension goes with 1/E.
TEST(Part, StiffnessIsTheMaterials) {
  const double soft = sag("fem_corotational", "implicit_euler", 0.25),
               plain = sag("fem_corotational", "implicit_euler", 1),
               stiff = sag("fem_corotational", "implicit_euler", 4);
  EXPECT_GT(plain, 1e-5);
  EXPECT_NEAR(soft / plain, 4, 0.1);
  EXPECT_NEAR(plain / stiff, 4, 0.1);
}

// Of every material, by implicit and explicit steps. Position-based ones stop short of their equilibrium, the
// farther the stiffer a body is, so theirs only goes the same way.
TEST(Part, StiffnessIsThatOfEveryMaterial) {
  const std::vector<std::pair<const char*, const char*>> ways = {
      {"fem_linear", "implicit_euler"},      {"fem_linear", "symplectic_euler"},
      {"fem_corotational", "bdf2"},          {"fem_corotational", "symplectic_euler"},
      {"fem_neo_hookean", "implicit_euler"}, {"fem_neo_hookean", "symplectic_euler"},
      {"mass_spring", "implicit_euler"},     {"mass_spring", "symplectic_euler"}};
  for (const auto& [model, integrator] : ways) {
    const double soft = sag(model, integrator, 0.25), plain = sag(model, integrator, 1),
                 stiff = sag(model, integrator, 4);
    EXPECT_NEAR(soft / plain, 4, 0.1) << model << ", " << integrator;
    EXPECT_NEAR(plain / stiff, 4, 0.1) << model << ", " << integrator;
  }
  const double soft = sag("xpbd", "implicit_euler", 0.25), plain = sag("xpbd", "implicit_euler", 1),
               stiff = sag("xpbd", "implicit_euler", 4);
  EXPECT_GT(stiff, 0);
  EXPECT_GT(plain, 2 * stiff);
  EXPECT_GT(soft, 2 * plain);
}

TEST(Part, StateIsSavedRestoredAndHashed) {
  Simulation first(anatomy(), options()), second(anatomy(), options());
  const std::uint64_t before = first.state_hash();
  TickInput input = part(PartEvent::Kind::detach, bone);
  Affine shape;
  shape.A(0, 1) = 0.5;
  shape.p = {0.1, 0.2, 0.3};
  input.parts.push_back({PartEvent::Kind::detach, somebody, organ, {}, 0});
  input.parts.push_back({PartEvent::Kind::set_stiffness, somebody, organ, {}, 2});
  input.parts.push_back({PartEvent::Kind::set_opacity, somebody, organ, {}, 0.5});
  input.parts.push_back({PartEvent::Kind::light, somebody, organ, {}, 1});
  first.step(input);
  EXPECT_NE(first.state_hash(), before);
  run(first, 10);
  const auto saved = first.checkpoint();
  second.restore(saved);
  EXPECT_EQ(second.part(organ), first.part(organ));
  EXPECT_EQ(second.part(bone), first.part(bone));
  EXPECT_EQ(second.state_hash(), first.state_hash());
  run(first, 40);
  run(second, 40);
  EXPECT_EQ(second.state_hash(), first.state_hash());
  TickInput again = part(PartEvent::Kind::inspect, bone, 0, shape);
  first.step(again);
  second.step(again);
  second.restore(first.checkpoint());
  run(first, 20);
  run(second, 20);
  EXPECT_EQ(second.state_hash(), first.state_hash());
  EXPECT_EQ(second.part(bone).shape.A, shape.A);
  second.restore(saved);  // to before it
  EXPECT_FALSE(second.part(bone).inspected);
  for (std::size_t i = 0; i < saved.size(); i += 97) {
    auto spoiled = saved;
    spoiled.resize(i);
    EXPECT_THROW(second.restore(spoiled), InputError);
  }
}

TEST(Part, ResetPutsItBackAsTheSceneHasIt) {
  Simulation simulation(anatomy(), options());
  for (const BodyId body : {bone, organ}) {
    simulation.step(part(PartEvent::Kind::detach, body));
    simulation.step(part(PartEvent::Kind::set_opacity, body, 0.5));
    run(simulation, 30);
    TickInput reset;
    reset.events.push_back({HandEvent::Kind::reset_body, 0, 0, body});
    simulation.step(reset);
    EXPECT_EQ(simulation.part(body), Part());
  }
  run(simulation, 60);
  EXPECT_EQ(simulation.rigid_state(bone).pose.p.y(), 0.5);
  EXPECT_LT(simulation.max_displacement(organ), 1e-4);
}

}  // namespace
}  // namespace prosector::test
