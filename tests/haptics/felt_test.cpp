// What the server tells of tissue under a hand that an arm moves, against what that tissue does.
#include <gtest/gtest.h>

#include <utility>

#include "common/hand.h"
#include "common/paths.h"
#include "common/rotation_between.h"
#include "common/scene/load_scene.h"
#include "server/accuracy/static_body.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/mechanics/soft/soft_matter.h"
#include "tests/folders.h"
#include "tests/haptics/felt_case.h"
#include "tests/physics/scalpel.h"
#include "tests/real_data.h"

namespace prosector::test {
namespace {

/// A block that is held at its foot.
SceneDesc held_block(double poisson_ratio = 0.4) {
  SceneDesc scene;
  scene.soft = {block()};
  scene.soft[0].attach = {{{0, -0.2, 0}, 0.215, 1e9}};
  scene.soft[0].material.poisson_ratio = poisson_ratio;
  scene.soft[0].geometry.cell = 0.012;
  scene.soft[0].material.youngs_modulus = 20000;
  scene.soft[0].gravity = false;
  scene.soft[0].contact.points = ContactPoints::surface;
  return scene;
}

constexpr std::array<double, fingers> pointing = {1, 0, 1, 1, 1};
const Quat down = rotation_between(-Vec3::UnitZ(), -Vec3::UnitY());

/// The wrist of a hand whose index finger points down and ends at a place, m.
Pose finger_at(const Vec3& place) {
  const Pose segment = hand_pose(right_hand, pointing)[4];
  const HandSegment& last = hand_segments(right_hand)[4];
  const Vec3 tip = segment * Vec3(0, 0, -(last.length + last.radius));
  return {place - down * tip, down};
}

/// The same, `clear` metres over the middle of the block.
Pose finger(double clear) {
  return finger_at({0.004, 0.06 + clear, 0.003});
}

/// A hand that an arm moves, at a place; `reaction`: N, of the arm.
TickInput moved_to(const Pose& at, double reaction, bool appears = false) {
  TickInput input = appears ? appear(at.p, at.q) : target(at.p, at.q);
  input.targets[0].flexion = pointing;
  input.targets[0].reaction = reaction;
  return input;
}
TickInput moved(double clear, double reaction, bool appears = false) {
  return moved_to(finger(clear), reaction, appears);
}

/// What the hand does to the body, N, by nodes.
VecX load_of_touches(const Simulation& simulation, BodyId body) {
  VecX load = VecX::Zero(3 * simulation.soft(body).nodes());
  for (const HandTouch& touch : simulation.around(feeler, 0).touches)
    for (std::size_t k = 0; k < touch.side.nodes; ++k)
      load.segment<3>(3 * static_cast<Eigen::Index>(touch.side.node[k])) -=
          touch.side.weight[k] * touch.exchanged;
  return load;
}

/// The body where a static solution has it under a load, m.
VecX at_rest_under(const soft::SoftBody& body, const VecX& load) {
  StaticBody still(body.desc(), body.anatomy());
  still.tie(body.attachment_stiffness() - still.matter().ties);
  const StaticAnswer answer = still.settle(load);
  EXPECT_TRUE(answer.usable());
  return answer.x;
}

class Felt : public testing::Test, protected FeltCase {
 protected:
  double clear_ = 0.02;  // m: where the finger is

  Felt() : FeltCase(held_block()) {
    step(moved(0.02, 0, true));
    for (int k = 0; k < 20; ++k) step(moved(0.02, 0));
  }
  /// Presses to that place until all is at rest and the body was asked.
  void press(double clear, double reaction = 40) {
    const double from = std::exchange(clear_, clear);
    for (int k = 1; k <= 60; ++k) step(moved(from + (clear - from) * k / 60, reaction));
    settle(moved(clear, reaction));
  }
};

TEST_F(Felt, TissueIsToldBeforeItIsMet) {
  step(moved(0.02, 0));
  ASSERT_EQ(last.planes.size(), 1u);
  const ContactPlane& plane = last.planes[0];
  EXPECT_EQ(plane.force, Vec3::Zero());
  EXPECT_GT(plane.normal.y(), 0.9);
  EXPECT_NEAR(plane.point.y(), 0.06, 1e-3) << "its surface";
  EXPECT_GT(plane.stiffness, 10);
  EXPECT_EQ(last.input_sequence, 5u);
}

TEST_F(Felt, FarFromAllNothingIsTold) {
  for (int k = 0; k < 60; ++k) step(moved(0.2, 0));
  EXPECT_TRUE(last.planes.empty());
}

TEST_F(Felt, ForceIsWhatTheContactDoes) {
  press(-0.006);
  const Vec3 contact = simulation.hands()[0].contact.force;  // on the body
  EXPECT_GT(reported_force().y(), 0.5);
  EXPECT_NEAR((reported_force() + contact).norm(), 0, 0.02 * contact.norm());
}

TEST_F(Felt, ThePlaneIsWhereTheArmIs) {
  press(-0.006);
  for (const ContactPlane& plane : last.planes) {
    const Vec3 of_arm = finger(-0.006) * plane.arm;
    EXPECT_LT(std::abs((of_arm - plane.point).dot(plane.normal)), 2e-4);
  }
}

TEST_F(Felt, StiffnessIsTheSlopeOfForceOverWay) {
  press(-0.006);
  const double reported = reported_stiffness();
  const double before = reported_force().y();
  press(-0.0065);
  const double slope = (reported_force().y() - before) / 0.0005;
  EXPECT_NEAR(reported / slope, 1, 0.11) << "of " << slope << " N/m";
}

TEST_F(Felt, TheBlockIsWhereAStaticSolutionUnderTheTouchesHasIt) {
  press(-0.006);
  const soft::SoftBody& body = simulation.soft(0);
  const VecX moved = simulation.soft_state(0).motion.x - body.rest();
  const VecX there = at_rest_under(body, load_of_touches(simulation, 0)) - body.rest();
  EXPECT_GT(there.lpNorm<Eigen::Infinity>(), 3e-3);
  EXPECT_LT((moved - there).norm(), 0.03 * there.norm());
}

TEST_F(Felt, NobodyPressesHarderThanTheyFeel) {
  press(-0.007, 40);
  EXPECT_GT(simulation.hands()[0].contact.force.norm(), 1.6);
  press(-0.007, 0.2);
  EXPECT_LT(simulation.hands()[0].contact.force.norm(), 1.3) << "1 N and a quarter more than the arm's";
}

TEST_F(Felt, BothEndsOfTheBookGrow) {
  press(-0.006);
  const double taken = last.taken;
  EXPECT_GT(taken, 0);
  press(0.02);
  EXPECT_GE(last.taken, taken);
  EXPECT_GT(last.given, 0) << "tissue pushes the hand out";
  EXPECT_GT(last.taken, last.given) << "and keeps some";
}

TEST(FeltTable, IsAHardSurfaceWhereItIs) {
  SceneDesc scene;
  scene.rigid = {table()};
  FeltCase c(scene);
  const auto go = [&](double from, double to, double reaction) {
    for (int k = 1; k <= 60; ++k) c.step(moved_to(finger_at({0, from + (to - from) * k / 60, 0}), reaction));
    for (int k = 0; k < 40; ++k) c.step(moved_to(finger_at({0, to, 0}), reaction));
  };
  const auto expect_surface = [&] {
    ASSERT_EQ(c.last.planes.size(), 1u);
    const ContactPlane& plane = c.last.planes[0];
    EXPECT_GT(plane.normal.y(), 0.99);
    EXPECT_EQ(plane.force, Vec3::Zero());
    EXPECT_EQ(plane.stiffness, hard_stiffness);
    EXPECT_NEAR(plane.point.y(), 0, 5e-4);
  };
  c.step(moved_to(finger_at({0, 0.02, 0}), 0, true));
  go(0.02, 0.0003, 0);
  expect_surface();
  go(0.0003, -0.002, 4);  // as an arm pushes back that is so deep in it
  expect_surface();
  EXPECT_GT(c.simulation.hands()[0].contact.force.norm(), 3) << "the hand presses";
}

TEST(FeltLiver, IsWhereAStaticSolutionUnderTheTouchesHasIt) {
  if (find_in_data("liver.inr.gz").empty())
    GTEST_SKIP() << "liver.inr.gz is not below " << default_data_dir();
  const SceneDesc scene = load_scene(source_path("deploy/scenes/cut.toml"));
  CompileOptions compile;
  compile.threads = 1;
  compile.data_dirs = {default_data_dir()};
  FeltCase c(scene, compile);
  const auto liver = static_cast<BodyId>(scene.rigid.size());
  const Vec3 place(-0.085, 1.04, 0.02);  // on its left lobe
  const auto at = [&](double deep) { return finger_at(place - Vec3(0, deep, 0)); };
  c.step(moved_to(at(-0.03), 40, true));
  for (int k = 0; k < 60; ++k) c.step(moved_to(at(-0.03), 40));
  const VecX before = c.simulation.soft_state(liver).motion.x;
  for (int k = 0; k <= 60; ++k) c.step(moved_to(at(-0.03 + 0.056 * k / 60), 40));
  c.settle(moved_to(at(0.026), 40));

  const soft::SoftBody& body = c.simulation.soft(liver);
  const VecX load = load_of_touches(c.simulation, liver);
  EXPECT_GT(load.reshaped(3, body.nodes()).rowwise().sum().norm(), 0.1) << "N";
  const VecX moved = c.simulation.soft_state(liver).motion.x - before;
  const VecX there = at_rest_under(body, load) - at_rest_under(body, VecX::Zero(load.size()));
  EXPECT_GT(there.lpNorm<Eigen::Infinity>(), 5e-3);
  EXPECT_LT((moved - there).norm(), 0.05 * there.norm());
}

TEST(FeltSheet, StiffnessIsTheSlopeOfForceOverWay) {
  SceneDesc scene = membrane_and_scalpel("mass_spring");
  scene.rigid.clear();
  scene.soft[0].pose.p.y() = 0.06;
  scene.soft[0].attach = {{{0, 0.06, 0.06}, 0.045, 1e9}, {{0, 0.06, -0.06}, 0.045, 1e9}};
  FeltCase c(scene);
  c.step(moved(0.02, 0, true));
  const auto press = [&](double from, double to) {
    for (int k = 1; k <= 60; ++k) c.step(moved(from + (to - from) * k / 60, 40));
    c.settle(moved(to, 40));
  };
  press(0.02, -0.015);
  const double reported = c.reported_stiffness(), before = c.reported_force().y();
  press(-0.015, -0.0155);
  const double slope = (c.reported_force().y() - before) / 5e-4;
  EXPECT_GT(before, 0.5);
  EXPECT_NEAR(reported / slope, 1, 0.15) << "of " << slope << " N/m";
}

TEST(FeltHands, TheStateIsTheSameWithAndWithout) {
  Simulation with(held_block(), options()), without(held_block(), options());
  FeltHands felt;
  const FeelingHand hand{feeler, 1};
  for (int k = 0; k < 60; ++k) {
    const TickInput input = moved(0.01 - 0.0003 * k, 0.02 * k, k == 0);
    with.step(input);
    without.step(input);
    (void)felt.follow(with, {&hand, 1});
    ASSERT_EQ(with.state_hash(), without.state_hash()) << k;
  }
}

TEST(TissueCompliance, IsThatOfAStaticSolution) {
  SoftDesc desc = block();
  desc.attach = {{{0, -0.2, 0}, 0.215, 1e9}};
  desc.material.poisson_ratio = 0.4;
  const Simulation simulation(
      [&] {
        SceneDesc scene;
        scene.soft = {desc};
        scene.soft[0].gravity = false;
        return scene;
      }(),
      options());
  const soft::SoftBody& body = simulation.soft(0);
  Patch patch;
  const std::uint32_t top = [&] {  // the node in the middle of the top
    std::uint32_t best = 0;
    double least = 1;
    for (Eigen::Index n = 0; n < body.nodes(); ++n) {
      const double off = (body.rest().segment<3>(3 * n) - Vec3(0, 0.06, 0)).norm();
      if (off < least) {
        least = off;
        best = static_cast<std::uint32_t>(n);
      }
    }
    return best;
  }();
  contact::ContactSide side;
  side.kind = contact::ContactSide::Kind::soft;
  side.nodes = 1;
  side.node[0] = top;
  side.weight[0] = 1;
  constexpr double stiff = 5000;  // N/m: between hand and point
  patch.points = {{side, stiff * patch.normal * patch.normal.transpose(), Mat3::Zero()}};
  patch.presses = true;
  TissueCompliance compliance(body.desc(), body.anatomy(), body.attachment_stiffness());
  const Slopes found = compliance.find(body.rest(), 1, {}, {patch}).at(0);

  StaticBody still(body.desc(), body.anatomy());
  still.tie(body.attachment_stiffness() - still.matter().ties);
  VecX load = VecX::Zero(3 * body.nodes());
  constexpr double little = 1e-3;  // N
  load[3 * top + 1] = -little;
  const StaticAnswer answer = still.settle(load);
  ASSERT_TRUE(answer.usable());
  const double gives = (body.rest()[3 * top + 1] - answer.x[3 * top + 1]) / little;
  EXPECT_NEAR(found.normal * (gives + 1 / stiff), 1, 0.02);
}

}  // namespace
}  // namespace prosector::test
