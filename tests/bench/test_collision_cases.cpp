// Tests the published collision study on fewer pairs.

#include <gtest/gtest.h>

#include "tests/bench/collision_cases.h"
#include "tests/bench/pair_errors.h"

namespace prosector {
namespace {

collision::Proximity deep(double gap) {
  collision::Proximity out;
  out.gap = gap;
  return out;
}

TEST(PairErrors, TellWhatIsFalseAndWhatIsMissed) {
  PairErrors errors(0.1);
  const PairContact up{-0.02, Vec3::UnitY()}, aside{-0.01, Vec3::UnitX()}, near{0.001, Vec3::UnitY()};
  errors.add(up, deep(-0.01));        // hit in both, depth error 0.1 of the size
  errors.add(aside, deep(-0.01));     // hit in both, normals at a right angle
  errors.add(up, deep(-0.02));        // hit in both, correct
  errors.add(up, std::nullopt);       // false hit
  errors.add(near, std::nullopt);     // near, but no hit
  errors.add(near, deep(-0.01));      // missed
  errors.add(std::nullopt, deep(0));  // missed
  ReportRow row;
  errors.tell(row);
  EXPECT_EQ(row["pairs"], 7);
  EXPECT_EQ(row["hits"], 5);
  EXPECT_DOUBLE_EQ(figure(row, "false_hits"), 0.5);
  EXPECT_DOUBLE_EQ(figure(row, "missed_hits"), 0.4);
  EXPECT_DOUBLE_EQ(figure(row, "depth_error"), 0);
  EXPECT_DOUBLE_EQ(figure(row, "normal_error_deg"), 0);
}

constexpr int few = 70;  // pairs

// Enclosing shapes miss no hit.
TEST(CollisionCases, SpheresAndBoxesOfRigidBodiesMissNothing) {
  for (const test::NamedParts& shape : test::shape_table()) {
    const RigidPairs pairs(shape, few);
    for (const Fidelity fidelity : {Fidelity::sphere, Fidelity::aabb, Fidelity::obb}) {
      const ReportRow row = pairs.measure(fidelity);
      EXPECT_GT(row["hits"], few / 4) << shape.name;
      EXPECT_EQ(figure(row, "missed_hits"), 0) << shape.name << " " << fidelity_name(fidelity);
      EXPECT_GT(figure(row, "false_hits"), 0) << shape.name << " " << fidelity_name(fidelity);
    }
  }
}

// The distance of a vertex to a box is exact, and an organ's deepest point in a box is a vertex.
TEST(CollisionCases, AnOrgansOwnMeshTellsABoxsDepthBest) {
  const test::NamedParts& box = test::shape_table().front();
  double coarser = 1;
  for (const Fidelity fidelity : {Fidelity::sphere, Fidelity::obb, Fidelity::hull, Fidelity::mesh}) {
    const ReportRow row = measure_organ_and_rigid(fidelity, box, few);
    EXPECT_LE(figure(row, "depth_error"), coarser) << fidelity_name(fidelity);
    EXPECT_LT(figure(row, "missed_hits"), 0.05) << fidelity_name(fidelity);
    coarser = figure(row, "depth_error");
  }
  EXPECT_LT(coarser, 1e-6);
}

TEST(CollisionCases, OrgansMissNoneOfThemselves) {
  const ReportRow mesh = measure_two_organs(Fidelity::mesh, few),
                  sphere = measure_two_organs(Fidelity::sphere, few);
  EXPECT_GT(mesh["hits"], few / 4);
  EXPECT_EQ(figure(mesh, "missed_hits"), 0);
  EXPECT_EQ(figure(sphere, "missed_hits"), 0);
  EXPECT_LT(figure(mesh, "false_hits"), figure(sphere, "false_hits"));
}

}  // namespace
}  // namespace prosector
