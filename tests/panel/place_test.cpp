// Where panels come up.

#include <gtest/gtest.h>

#include <random>

#include "common/panel.h"
#include "server/physics/panel/panel_place.h"

namespace prosector {
namespace {

PanelSite site() {
  return {{0.02, 1.05, 0.03}, {-0.08, 0.95, -0.06}, {0.1, 1.06, 0.07}, {0.05, 1.5, 0.6}, -1};
}

TEST(PanelPlace, FacesTheReader) {
  const PanelSite s = site();
  const Pose panel = place_panel(s);
  EXPECT_GT((panel.q * Vec3::UnitZ()).dot((s.reader - panel.p).normalized()), 0.999);
  EXPECT_GT((panel.q * Vec3::UnitY()).y(), 0.5) << "upright";
  EXPECT_NEAR((panel.q * Vec3::UnitX()).y(), 0, 1e-12) << "its lines are level";
}

TEST(PanelPlace, StandsBesideThePartAndInReach) {
  for (const double side : {-1.0, 1.0}) {
    PanelSite s = site();
    s.side = side;
    const Pose panel = place_panel(s);
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5}) {
        const Vec3 corner = panel * Vec3(x * panel_width, y * panel_height, 0);
        EXPECT_FALSE((corner.array() > s.lo.array()).all() && (corner.array() < s.hi.array()).all());
      }
    EXPECT_LT((panel.p - s.touched).norm(), 0.5);
    const Vec3 right = Vec3::UnitY().cross(s.reader - s.touched);
    EXPECT_GT(side * right.dot(panel.p - s.touched), 0) << "on the side asked for";
  }
}

TEST(PanelPlace, IsAProperPoseForAnySite) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> wide(-1000, 1000), narrow(-0.1, 0.1);
  for (int i = 0; i < 2000; ++i) {
    const auto place = [&](auto& d) { return Vec3(d(random), d(random), d(random)); };
    PanelSite s;
    s.touched = place(wide);
    s.reader = i % 3 == 0 ? place(wide) : i % 3 == 1 ? Vec3(s.touched + place(narrow)) : s.touched;
    if (i % 7 == 0) s.reader = s.touched + Vec3(0, 1, 0);
    s.lo = s.touched - place(narrow).cwiseAbs();
    s.hi = s.touched + place(narrow).cwiseAbs();
    s.side = i % 2 == 0 ? 1 : -1;
    const Pose panel = place_panel(s);
    ASSERT_TRUE(is_finite(panel)) << i;
    ASSERT_NEAR(panel.q.norm(), 1, 1e-9);
    ASSERT_LT((panel.p - s.touched).norm(), 0.6);
    ASSERT_GT((panel.q * Vec3::UnitY()).y(), 0.3);
  }
}

}  // namespace
}  // namespace prosector
