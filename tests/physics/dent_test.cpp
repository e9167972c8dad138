// The dent that a mesh does not resolve under a ball.

#include "server/physics/mechanics/contact/dent.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/physics/half_space.h"

namespace prosector::test {
namespace {

constexpr double mm = 1e-3;

TEST(Dent, HertzGivesTheRadiusOfThePatch) {
  constexpr double radius = 10 * mm, depth = 1 * mm, modulus = 6000;
  const double force = 4. / 3 * modulus * std::sqrt(radius) * std::pow(depth, 1.5);
  EXPECT_NEAR(contact::contact_radius(force, radius, modulus), std::sqrt(radius * depth), 1e-12);
  EXPECT_EQ(contact::contact_radius(0, radius, modulus), 0);
}

// Under a ball, a bed of springs K yields by √(F/πKR). With the mesh's share a/l, the depth is Hertz's.
TEST(Dent, ContactAndMeshYieldLikeAHalfSpace) {
  constexpr double radius = 10 * mm, modulus = 6000;
  for (const double patch : {1 * mm, 2 * mm, 4 * mm})
    for (const double length : {6 * mm, 10 * mm, 18 * mm}) {
      const double depth = patch * patch / radius, force = 4. / 3 * modulus * patch * patch * patch / radius,
                   springs = modulus * contact::dent_stiffness(patch, length),
                   of_contact = std::sqrt(force / (std::numbers::pi * springs * radius));
      EXPECT_NEAR(of_contact + patch / length * depth, depth, 1e-9 * depth) << patch << ' ' << length;
    }
}

// A mesh that resolves the patch leaves little to the contact: the mean of Hertz's depth is 4/5.
TEST(Dent, VanishesInFineMeshes) {
  double last = contact::dent_stiffness(1 * mm, 10 * mm);
  for (double length = 10 * mm; length > 1.26 * mm; length *= 0.999) {
    const double now = contact::dent_stiffness(1 * mm, length);
    EXPECT_GE(now, last) << length;
    EXPECT_LT(now, 1.2 * last) << length;
    last = now;
  }
  EXPECT_GT(last, 40 * contact::dent_stiffness(1 * mm, 10 * mm));
  EXPECT_TRUE(std::isfinite(contact::dent_stiffness(1 * mm, 0.1 * mm)));
  EXPECT_TRUE(std::isfinite(contact::dent_stiffness(0, 10 * mm)));
}

// Dents of coarse elements are more of a half-space's, and locked elements leave more to the contact.
TEST(Dent, LengthGrowsWithElementsAndLocking) {
  EXPECT_NEAR(contact::dent_length(20 * mm, 0.4, 0.3), 2 * contact::dent_length(10 * mm, 0.4, 0.3), 1e-12);
  double last = 0;
  for (const double nu : {0.3, 0.4, 0.45, 0.47, 0.49, 0.495, 0.499}) {
    const double length = contact::dent_length(10 * mm, 0.4, nu);
    EXPECT_GT(length, last) << nu;
    last = length;
  }
  EXPECT_EQ(contact::dent_length(10 * mm, 0.4, 0.4999), last);
}

// The law of a mesh's displacement, on half-spaces of linear elements under Hertz's pressure.
TEST(Dent, LengthIsTheMeshs) {
  for (const double nu : {0.3, 0.49})
    for (const double patch : {0.3, 0.7, 1.4}) {  // cells
      const MeshYield found = yield_of_half_space(nu, patch);
      const double by_law = 0.75 / contact::dent_length(1, found.spread, nu);
      std::printf("nu %.2f, patch of %.1f cells: spread %.3f, displacement %.3f, by the law %.3f\n", nu,
                  patch, found.spread, found.displacement, by_law);
      EXPECT_NEAR(by_law / found.displacement, 1, 0.1) << nu << ' ' << patch;
    }
}

}  // namespace
}  // namespace prosector::test
