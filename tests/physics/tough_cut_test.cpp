// Tough tissue under every rung: the hand keeps the blade, and what it is drawn through parts, for as much
// force and work.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/physics/scalpel.h"

namespace prosector::test {
namespace {

constexpr double height = 0.06, length = 0.1;  // m, of what is cut

struct Felt {
  bool held = false, parted = false;
  double most = 0, work = 0;  // N and J, of the hand along the stroke
};

Felt draw_right_through(const std::string& model, double toughness) {
  SceneDesc scene = block_and_scalpel();
  scene.rigid[0].edges = {{{0, -0.04, 0}, {0, -0.2, 0}}};
  SoftDesc& body = scene.soft[0];
  body.model = model;
  body.youngs_modulus = 2e4;
  body.toughness = toughness;
  Simulation simulation(scene, options());
  Vec3 at = take(simulation);
  Felt felt;
  double before = simulation.rigid_state(scalpel).pose.p.x();
  for (int i = 0; i < 200; ++i) {
    at.x() += 0.0016;
    const StepReport& report = simulation.step(target(at));
    for (const TopologyChange& change : report.topology) felt.parted = felt.parted || change.piece_of;
    const double force = simulation.hands()[0].contact.force.x();
    const double now = simulation.rigid_state(scalpel).pose.p.x();
    felt.most = std::max(felt.most, force);
    felt.work += force * (now - before);
    before = now;
  }
  felt.held = simulation.hands()[0].holding == std::optional<BodyId>(scalpel);
  return felt;
}

class ToughTissue : public testing::TestWithParam<double> {};

TEST_P(ToughTissue, TakesAsMuchUnderEveryRung) {
  const double toughness = GetParam();
  const Felt fem = draw_right_through("fem_corotational", toughness);
  EXPECT_GT(fem.most, 0.9 * toughness * height);  // a blade that leans is drawn along itself a little
  EXPECT_LT(fem.most, 1.5 * toughness * height);  // what begins a cut
  EXPECT_GT(fem.work, toughness * height * length);
  for (const std::string model :
       {"mass_spring", "xpbd", "fem_linear", "fem_corotational", "fem_neo_hookean"}) {
    SCOPED_TRACE(model);
    const Felt felt = draw_right_through(model, toughness);
    RecordProperty(model, std::to_string(felt.most) + " N, " + std::to_string(felt.work) + " J");
    EXPECT_TRUE(felt.held);
    EXPECT_TRUE(felt.parted);
    EXPECT_NEAR(felt.most, fem.most, 0.02 * fem.most);
    EXPECT_NEAR(felt.work, fem.work, 0.02 * fem.work);
  }
}

INSTANTIATE_TEST_SUITE_P(Toughness, ToughTissue, testing::Values(30.0, 164.0));

}  // namespace
}  // namespace prosector::test
