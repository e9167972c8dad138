#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/coupled/recovery.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/mechanics/soft/unfold.h"
#include "tests/physics/patched_state.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

TEST(Recovery, BodyThatOverflowsIsStoppedAndReportedAndTheRestGoesOn) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("ball", "sphere", {0.04, 0, 0}, {0.5, 2, 0}),
                 part_body("weight", "sphere", {0.03, 0, 0}, {0, 0.1, 0})};
  scene.soft = {block()};
  Simulation simulation(scene, options());
  run(simulation, 30);  // the weight has landed: the block moves
  const soft::SoftBodyState before = simulation.soft_state(3);
  ASSERT_FALSE(before.asleep);
  simulation.restore(
      with_values(simulation.checkpoint(), before.motion.v, VecX::Constant(before.motion.v.size(), 1e300)));
  const double falling = simulation.rigid_state(1).linear_velocity.y();
  const StepReport& report = simulation.step({});
  bool reset = false;
  for (const BodyReport& body : report.bodies) reset = reset || (body.body == "block" && body.reset);
  EXPECT_TRUE(reset);
  EXPECT_TRUE(simulation.soft_state(3).motion.x.allFinite());
  EXPECT_EQ(simulation.soft_state(3).motion.x, before.motion.x);
  EXPECT_EQ(simulation.soft_state(3).motion.v.norm(), 0);
  EXPECT_NEAR(simulation.rigid_state(1).linear_velocity.y() - falling, -9.81 / 60, 1e-5);
  run(simulation, 120);
  for (const BodyReport& body : simulation.step({}).bodies) EXPECT_FALSE(body.reset) << body.body;
  EXPECT_LT(simulation.max_displacement(3), 0.03);
  EXPECT_TRUE(is_finite(simulation.rigid_state(2).pose));
}

/// Tells whether an untouched block of so many cells along each edge is unfolded within two seconds after one
/// of its corners was pushed through what is around it. `share`: of its volume that is inside out then.
bool unfolds(int cells, double& share) {
  soft::SoftBody body(block(), make_block({0.1, 0.1, 0.1}, {cells, cells, cells}));
  soft::SoftBodyState state = body.initial_state();
  Eigen::Index corner = 0;
  state.motion.x.reshaped(3, body.nodes()).colwise().sum().minCoeff(&corner);
  state.motion.x.segment<3>(3 * corner).array() += 0.15 / cells;
  share = soft::inverted_share(body.linear_tets(), state.motion.x);
  coupled::SoftMember member{0, &body, &state};
  for (int tick = 0; tick < 120; tick += 8)
    if (coupled::unfold_if_tangled(member, {}, body.rest(), 1.0 / 60, 8)) return true;
  return false;
}

// An organ with an open cut was reset to its rest shape every second, because a sliver beside the cut was
// flat.
TEST(Recovery, SliversStayAsTheyAreAndWhatIsMoreIsUnfolded) {
  double share = 0;
  EXPECT_FALSE(unfolds(12, share)) << share;
  EXPECT_GT(share, 0);
  EXPECT_LT(share, 1e-3);
  EXPECT_TRUE(unfolds(3, share)) << share;
  EXPECT_GT(share, 1e-3);
}

/// A soft block that is tied at its floor, and a stiff one that rests on it.
SceneDesc soft_under_stiff() {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {block("under"), block("over")};
  for (SoftDesc& soft : scene.soft) soft.gravity = false;
  scene.soft[0].pose.p.y() += 0.05;
  scene.soft[0].material.poisson_ratio = 0.3;
  scene.soft[0].material.youngs_modulus = 2000;
  scene.soft[0].attach = {{{0, 0.05 - 1000, 0}, std::hypot(1000, 0.08), 1e8}};  // the nodes of its floor
  scene.soft[1].pose.p.y() += 0.112;
  scene.soft[1].material.youngs_modulus = 1e5;
  return scene;
}

// A held liver squeezed the kidney below it to less than 0.7 of its volume. The kidney was put into its rest
// shape every second, though the hand left no room for that shape.
TEST(Recovery, TissueUnderHeldTissueStaysSqueezedAndGetsItsVolumeBackWhenTheHandLeaves) {
  Simulation simulation(soft_under_stiff(), options());
  const auto palm_over = [](double gap) { return Vec3(0, 0.172 + gap, 0.06); };
  int resets = 0;
  const auto step = [&](const TickInput& input) {
    for (const BodyReport& body : simulation.step(input).bodies) resets += body.reset;
    const soft::SoftBody& under = simulation.soft(1);
    return soft::volume_share(under.linear_tets(), simulation.soft_state(1).motion.x);
  };
  step(appear(palm_over(0.05)));
  for (int i = 0; i < 90; ++i) step(target(palm_over(0.05 - 0.1 * i / 90)));
  double pressed = 1;
  for (int i = 0; i < 120; ++i) pressed = step(target(palm_over(-0.05)));
  EXPECT_LT(pressed, 0.7);
  EXPECT_EQ(resets, 0);
  double free = 0;
  for (int i = 0; i < 180; ++i) free = step(target(palm_over(0.2)));
  EXPECT_NEAR(free, 1, 0.02);
}

// A kidney that a liver pressed onto the table kept 0.47 of its volume permanently, because the press was
// taken for one between rigid bodies. Tissue that no hand holds leaves room: the lighter body is moved out of
// it.
TEST(Recovery, TissueUnderLooseTissueGetsItsVolumeBack) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {block("under"), block("over")};
  SoftDesc &under = scene.soft[0], &over = scene.soft[1];
  under.configuration.model = "fem_neo_hookean";
  under.material.poisson_ratio = 0.3;
  under.material.youngs_modulus = 4000;
  over.material.youngs_modulus = 1e5;
  over.material.density = 12 * under.material.density;
  over.pose.p.y() += 0.09;
  Simulation simulation(scene, options());
  double least = 1, now = 1;
  int resets = 0;
  for (int tick = 0; tick < 300; ++tick) {
    for (const BodyReport& body : simulation.step({}).bodies) resets += body.reset;
    now = soft::volume_share(simulation.soft(1).linear_tets(), simulation.soft_state(1).motion.x);
    least = std::min(least, now);
  }
  EXPECT_LT(least, 0.6);
  EXPECT_GE(resets, 1);
  EXPECT_NEAR(now, 1, 0.1);
}

// 50 kg pressed a pad flat. The pad was put into its rest shape around the weight, and stayed so.
TEST(Recovery, WeightThatTissueCannotBearIsMovedAboveItAndReported) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("weight", "box", {0.1, 0.1, 0.1}, {0, 0.12, 0})};
  scene.rigid[1].material.mass = 50;
  scene.soft = {block("pad")};
  scene.soft[0].geometry.size = {0.16, 0.06, 0.16};
  scene.soft[0].material.youngs_modulus = 5400;
  Simulation simulation(scene, options());
  int moved = 0;
  for (int tick = 0; tick < 180; ++tick)
    for (const BodyReport& body : simulation.step({}).bodies)
      if (body.body == "weight" && body.reset) {
        ++moved;
        EXPECT_NE(body.note.find("inside pad"), std::string::npos) << body.note;
        EXPECT_GT(simulation.rigid_state(1).pose.p.y(), 0.06);
      }
  EXPECT_GE(moved, 1);
}

}  // namespace
}  // namespace prosector::test
