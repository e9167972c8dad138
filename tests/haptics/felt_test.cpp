// What the server tells of tissue under a hand that an arm moves, against what that tissue does.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "server/accuracy/static_body.h"
#include "server/haptics/felt_hands.h"
#include "server/physics/soft/soft_body.h"
#include "server/physics/soft/soft_matter.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

const HandRef feeler{somebody, right_hand};

/// A block that is held at its foot.
SceneDesc held_block(double poisson_ratio = 0.4) {
  SceneDesc scene;
  scene.soft = {block()};
  scene.soft[0].attach = {{{0, 0, 0}, 0.09, 1e9}};
  scene.soft[0].poisson_ratio = poisson_ratio;
  scene.soft[0].gravity = false;
  scene.soft[0].contact = "surface";
  return scene;
}

/// The palm's lower side above the middle of the block, `clear` metres over its top.
Vec3 palm(double clear) {
  return {-0.004, 0.06 + 0.011 + clear, 0.045};
}

/// A hand that an arm moves, at a place; `reaction`: N, of the arm.
TickInput moved(const Vec3& at, double reaction) {
  TickInput input = target(at);
  input.targets[0].reaction = reaction;
  return input;
}

class Felt : public testing::Test {
 protected:
  Simulation simulation_{held_block(), options()};
  FeltHands felt_;
  FeltPlanes last_;

  Felt() {
    TickInput first = appear(palm(0.02));
    first.targets[0].reaction = 0;
    step(first);
  }
  void step(const TickInput& input) {
    simulation_.step(input);
    const FeelingHand hand{feeler, 5};
    last_ = felt_.follow(simulation_, {&hand, 1}).at(0);
  }
  /// Presses to that place until all is at rest and the body was asked.
  void press(double clear, double reaction = 40) {
    for (int k = 0; k < 240; ++k) step(moved(palm(clear), reaction));
    for (int k = 0; k < 200; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      step(moved(palm(clear), reaction));
    }
  }
  Vec3 told_force() const {
    Vec3 out = Vec3::Zero();
    for (const ContactPlane& plane : last_.planes) out += plane.force;
    return out;
  }
  /// N/m, upwards: of a hand that moves down.
  double told_stiffness() const {
    double out = 0;
    for (const ContactPlane& plane : last_.planes)
      out += plane.stiffness * plane.normal.y() * plane.normal.y() +
             plane.tangential * (1 - plane.normal.y() * plane.normal.y());
    return out;
  }
};

TEST_F(Felt, TissueIsToldBeforeItIsMet) {
  step(moved(palm(0.02), 0));
  ASSERT_EQ(last_.planes.size(), 1u);
  const ContactPlane& plane = last_.planes[0];
  EXPECT_EQ(plane.force, Vec3::Zero());
  EXPECT_GT(plane.normal.y(), 0.9);
  EXPECT_NEAR(plane.point.y(), 0.06, 1e-3) << "its surface";
  EXPECT_GT(plane.stiffness, 10);
  EXPECT_EQ(last_.input_sequence, 5u);
}

TEST_F(Felt, FarFromAllNothingIsTold) {
  step(moved(palm(0.2), 0));
  EXPECT_TRUE(last_.planes.empty());
}

TEST_F(Felt, ForceIsWhatTheContactDoes) {
  press(-0.006);
  const Vec3 contact = simulation_.hands()[0].contact.force;  // on the body
  EXPECT_GT(told_force().y(), 0.5);
  EXPECT_NEAR((told_force() + contact).norm(), 0, 0.02 * contact.norm());
}

TEST_F(Felt, ThePlaneIsWhereTheArmIs) {
  press(-0.006);
  for (const ContactPlane& plane : last_.planes) {
    const Vec3 of_arm = Pose{palm(-0.006), Quat::Identity()} * plane.arm;
    EXPECT_LT(std::abs((of_arm - plane.point).dot(plane.normal)), 2e-4);
  }
}

TEST_F(Felt, StiffnessIsTheSlopeOfForceOverWay) {
  press(-0.006);
  const double told = told_stiffness();
  const double before = told_force().y();
  press(-0.0065);
  const double slope = (told_force().y() - before) / 0.0005;
  EXPECT_NEAR(told / slope, 1, 0.11) << "of " << slope << " N/m";
}

TEST_F(Felt, NobodyPressesHarderThanTheyFeel) {
  press(-0.01, 40);
  const double free = simulation_.hands()[0].contact.force.norm();
  press(-0.01, 0.5);
  const double bounded = simulation_.hands()[0].contact.force.norm();
  EXPECT_GT(free, 2);
  EXPECT_LT(bounded, 1.7) << "1 N and a quarter more than the arm's";
}

TEST_F(Felt, BothEndsOfTheBookGrow) {
  press(-0.006);
  const double taken = last_.taken;
  EXPECT_GT(taken, 0);
  press(0.02);
  EXPECT_GE(last_.taken, taken);
  EXPECT_GT(last_.given, 0) << "tissue pushes the hand out";
  EXPECT_GT(last_.taken, last_.given) << "and keeps some";
}

TEST(FeltHands, TheStateIsTheSameWithAndWithout) {
  Simulation with(held_block(), options()), without(held_block(), options());
  FeltHands felt;
  const FeelingHand hand{feeler, 1};
  TickInput first = appear(palm(0.01));
  first.targets[0].reaction = 0;
  for (int k = 0; k < 60; ++k) {
    const TickInput input = k == 0 ? first : moved(palm(0.01 - 0.0003 * k), 0.02 * k);
    with.step(input);
    without.step(input);
    (void)felt.follow(with, {&hand, 1});
    ASSERT_EQ(with.state_hash(), without.state_hash()) << k;
  }
}

TEST(TissueCompliance, IsThatOfAStaticSolution) {
  SoftDesc desc = block();
  desc.attach = {{{0, 0, 0}, 0.09, 1e9}};
  desc.poisson_ratio = 0.4;
  const Simulation simulation(
      [&] {
        SceneDesc scene;
        scene.soft = {desc};
        scene.soft[0].gravity = false;
        return scene;
      }(),
      options());
  const SoftBody& body = simulation.soft(0);
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
  ContactSide side;
  side.kind = ContactSide::Kind::soft;
  side.nodes = 1;
  side.node[0] = top;
  side.weight[0] = 1;
  patch.points = {side};
  patch.weight = {1};
  TissueCompliance compliance(body.desc(), body.anatomy(), body.attachment_stiffness());
  const Compliance found = compliance.find(body.rest(), 1, {}, {patch}).at(0);

  StaticBody still(body.desc(), body.anatomy());
  still.tie(body.attachment_stiffness() - still.matter().ties);
  VecX load = VecX::Zero(3 * body.nodes());
  constexpr double little = 1e-3;  // N
  load[3 * top + 1] = -little;
  const StaticAnswer answer = still.settle(load);
  ASSERT_TRUE(answer.usable());
  const double gives = (body.rest()[3 * top + 1] - answer.x[3 * top + 1]) / little;
  EXPECT_NEAR(found.normal / gives, 1, 0.02);
}

}  // namespace
}  // namespace prosector::test
