// Displacements at places of a body: its elements' own fields, exactly.

#include "server/accuracy/displacement.h"

#include <gtest/gtest.h>

#include "tests/accuracy/boxes.h"

namespace prosector {
namespace {

StaticBody made(const char* element, unsigned cells) {
  SoftDesc desc = test::pinned(0, 5400, 0.3);
  desc.configuration.element = element;
  return StaticBody(desc, test::box({0.2, 0.1, 0.1}, 2 * cells, cells, cells));
}

Vec3 linear(const Vec3& x) {
  return {0.1 * x.x() - 0.2 * x.z(), 0.05 * x.y() + 0.1 * x.x(), 0.3 * x.z()};
}
Vec3 quadratic(const Vec3& x) {
  return {x.x() * x.y(), x.z() * x.z() - x.y(), 2 * x.x() * x.x()};
}

template <class Field>
VecX moved(const StaticBody& body, const Field& field) {
  VecX x = body.rest();
  for (Eigen::Index k = 0; k < x.size(); k += 3) x.segment<3>(k) += field(Vec3(body.rest().segment<3>(k)));
  return x;
}

TEST(Displacement, ElementsReproduceTheirOwnFields) {
  const std::vector<Vec3> places = places_in(made("tet4", 3).mesh(), 100);
  ASSERT_GT(places.size(), 50u);
  for (const unsigned cells : {2u, 3u}) {
    const StaticBody flat = made("tet4", cells), curved = made("tet10", cells);
    const Probes in_flat(flat, places), in_curved(curved, places);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const auto of_flat = in_flat.displacement(k, moved(flat, linear));
      const auto of_curved = in_curved.displacement(k, moved(curved, quadratic));
      ASSERT_TRUE(of_flat && of_curved) << k;
      EXPECT_LT((*of_flat - linear(places[k])).norm(), 1e-12);
      EXPECT_LT((*of_curved - quadratic(places[k])).norm(), 1e-12);
    }
  }
}

TEST(Displacement, PlacesOutsideAreToldApart) {
  const StaticBody body = made("tet4", 2);
  const std::vector<Vec3> places = {{0.05, 0.05, 0.05}, {0.5, 0.05, 0.05}};
  const Probes probes(body, places);
  EXPECT_TRUE(probes.displacement(0, body.rest()));
  EXPECT_FALSE(probes.displacement(1, body.rest()));
}

TEST(Displacement, DifferencesAreRelative) {
  const StaticBody coarse = made("tet4", 2), fine = made("tet4", 4);
  const std::vector<Vec3> places = places_in(fine.mesh(), 80);
  const Probes in_coarse(coarse, places), in_fine(fine, places);
  const auto larger = [](const Vec3& x) -> Vec3 { return 1.03 * linear(x); };
  EXPECT_NEAR(
      relative_difference(in_coarse, moved(coarse, larger), in_fine, moved(fine, linear), places.size()),
      0.03, 1e-9);
}

}  // namespace
}  // namespace prosector
