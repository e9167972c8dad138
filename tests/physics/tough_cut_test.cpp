// Tough tissue under every rung: the hand keeps the blade, and what it is drawn through parts, for as much
// force and work.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/physics/scalpel.h"

namespace prosector::test {
namespace {

constexpr double height = 0.06, length = 0.1;  // m, of what is cut

struct Felt {
  bool held = false, parted = false;
  double most = 0, work = 0;  // N and J, of the hand along the stroke
};

Felt draw_right_through(const std::string& model, const std::string& element, double toughness) {
  SceneDesc scene = block_and_scalpel();
  scene.rigid[0].edges = {{{0, -0.04, 0}, {0, -0.2, 0}}};
  SoftDesc& body = scene.soft[0];
  body.configuration.model = model;
  body.configuration.element = element;
  body.material.youngs_modulus = 2e4;
  body.material.toughness = toughness;
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

/// Of the same tissue in two discretisations.
void expect_near(const Felt& felt, const Felt& other, double share) {
  EXPECT_TRUE(felt.held);
  EXPECT_TRUE(felt.parted);
  EXPECT_NEAR(felt.most, other.most, share * other.most);
  EXPECT_NEAR(felt.work, other.work, share * other.work);
}

class ToughTissue : public testing::TestWithParam<double> {};

TEST_P(ToughTissue, TakesAsMuchUnderEveryRung) {
  const double toughness = GetParam();
  const auto felt_under = [&](const std::string& model, const std::string& element) {
    const Felt felt = draw_right_through(model, element, toughness);
    RecordProperty(model + "_" + element,
                   std::to_string(felt.most) + " N, " + std::to_string(felt.work) + " J");
    return felt;
  };
  const Felt fem = felt_under("fem_corotational", "tet4");
  EXPECT_GT(fem.most, 0.9 * toughness * height);  // a blade that leans is drawn along itself a little
  EXPECT_LT(fem.most, 1.5 * toughness * height);  // what begins a cut
  EXPECT_GT(fem.work, toughness * height * length);
  for (const std::string model : {"mass_spring", "xpbd", "fem_linear", "fem_neo_hookean"}) {
    SCOPED_TRACE(model);
    expect_near(felt_under(model, "tet4"), fem, 0.02);
  }
  SCOPED_TRACE("tet10");
  expect_near(felt_under("fem_corotational", "tet10"), fem, 0.05);  // which bend more
}

INSTANTIATE_TEST_SUITE_P(Toughness, ToughTissue, testing::Values(30.0, 164.0));

}  // namespace
}  // namespace prosector::test
