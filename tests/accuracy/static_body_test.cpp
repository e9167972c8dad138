// A body at rest under loads, against closed forms and against itself.

#include "server/accuracy/static_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "server/accuracy/act.h"
#include "server/accuracy/outer_surface.h"
#include "server/accuracy/secants.h"
#include "tests/accuracy/boxes.h"

namespace prosector {
namespace {

VecX weights(const StaticBody& body, const Vec3& acceleration) {
  return load_of({"weight", acceleration, {}}, body);
}

double end_moved(const StaticBody& body, const StaticAnswer& answer, double height) {
  double sum = 0;
  int count = 0;
  for (Eigen::Index k = 0; k < body.rest().size(); k += 3) {
    if (std::abs(body.rest()[k + 1] - height) > 1e-9) continue;
    sum += answer.x[k + 1] - body.rest()[k + 1];
    ++count;
  }
  return sum / count;
}

/// A bar of ν = 0 under its weight gets longer by ρgL²/2E. Quadratic elements have that, since their weight
/// is given to nodes by shape functions.
TEST(StaticBody, HangingBarIsAsLongAsTheClosedFormSays) {
  constexpr double length = 0.2, modulus = 1e7;
  for (const char* element : {"tet4", "tet10"}) {
    SoftDesc desc = test::pinned(1, modulus, 0);
    desc.configuration.element = element;
    StaticBody body(desc, test::box({0.05, length, 0.05}, 2, 8, 2));
    const StaticAnswer answer = body.settle(weights(body, -test::gravity));
    ASSERT_TRUE(answer.usable());
    const double right = 1000 * 9.81 * length * length / (2 * modulus);
    const double longer = end_moved(body, answer, length) - end_moved(body, answer, 0);
    EXPECT_NEAR(longer / right, 1, body.quadratic() ? 1e-3 : 2e-3) << element;
  }
}

/// What is left of the forces is what the stop allows, for every law, also where a compressed body's
/// projected Hessian is too stiff.
TEST(StaticBody, ForcesBalanceUnderEveryLaw) {
  for (const char* model : {"fem_linear", "fem_corotational", "fem_neo_hookean", "fem_neo_hookean_polynomial",
                            "fem_stvk", "mass_spring"}) {
    SoftDesc desc = test::pinned(1, 5400, 0.45);
    desc.configuration.model = model;
    StaticBody body(desc, test::box({0.1, 0.1, 0.1}, 4, 4, 4));
    const VecX load = weights(body, test::gravity);
    const StaticAnswer once = body.settle(load), again = body.settle(load);
    ASSERT_TRUE(once.usable()) << model;
    EXPECT_EQ((once.x - again.x).norm(), 0) << model << ": the answer hangs on what was before";
    const double down = -end_moved(body, once, 0.1);
    EXPECT_GT(down, 0.003) << model;
    EXPECT_LT(down, 0.02) << model;
  }
}

TEST(StaticBody, SaysWhenItsOwnWeightCrushesIt) {
  StaticBody body(test::pinned(1, 150, 0.3), test::box({0.1, 0.1, 0.1}, 4, 4, 4));
  EXPECT_FALSE(body.settle(weights(body, 2 * test::gravity)).usable());
}

/// Along directions that pairs told of, the corrected inverse is right whatever the one at hand.
TEST(Secants, KnowWhatStepsTold) {
  const Vec3 true_diagonal(2, 50, 7);
  Secants secants;
  for (int axis = 0; axis < 3; ++axis) {
    const VecX step = Vec3::Unit(axis);
    secants.remember(step, true_diagonal.asDiagonal() * step);
  }
  const VecX gradient = Vec3(3, -4, 5);
  const VecX direction = secants.direction(gradient, [](const VecX& r) -> VecX { return 0.01 * r; });
  EXPECT_LT((direction + VecX(gradient.cwiseQuotient(true_diagonal))).norm(), 1e-12);
}

/// Whatever the mesh, a press is its force, at its point.
TEST(Acts, APressIsItsForceAtItsPoint) {
  const Press press{Vec3(0.043, 0.1, 0.056), -Vec3::UnitY(), 0.012, 0.7};
  for (const char* element : {"tet4", "tet10"})
    for (const unsigned cells : {2u, 3u, 5u}) {
      SoftDesc desc = test::pinned(1, 5400, 0.45);
      desc.configuration.element = element;
      const StaticBody body(desc, test::box({0.1, 0.1, 0.1}, cells, cells, cells));
      const VecX load = load_of({"press", Vec3::Zero(), press}, body);
      Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
      for (Eigen::Index k = 0; k < load.size(); k += 3) {
        force += load.segment<3>(k);
        moment += (body.rest().segment<3>(k) - press.point).cross(Vec3(load.segment<3>(k)));
      }
      EXPECT_LT((force - press.force * press.inward).norm(), 1e-9) << element << ", " << cells;
      EXPECT_LT(moment.norm(), 0.06 * press.force * press.radius) << element << ", " << cells;
    }
}

TEST(OuterSurface, HasTheBoxAreaAndThickness) {
  const Anatomy box = test::box({0.3, 0.1, 0.2}, 3, 2, 4);
  const auto faces = outer_faces(box.tets);
  double area = 0;
  Vec3 sum = Vec3::Zero();
  for (const OuterFace& face : faces) {
    area += area_vector(box.tets, face).norm();
    sum += area_vector(box.tets, face);
  }
  EXPECT_NEAR(area, 0.22, 1e-12);
  EXPECT_LT(sum.norm(), 1e-12) << "all face outwards";
  EXPECT_NEAR(thickness(box.tets, faces), 4 * 0.006 / 0.22, 1e-12);
}

}  // namespace
}  // namespace prosector
