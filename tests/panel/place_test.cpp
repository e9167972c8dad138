// Where panels come up.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "common/panel.h"
#include "server/physics/mechanics/panel/panel_place.h"

namespace prosector {
namespace {

panel::PanelSite site() {
  return {{0.02, 1.05, 0.03}, {-0.08, 0.95, -0.06}, {0.1, 1.06, 0.07}, {{0.05, 1.5, 0.6}, Vec3::Zero()}, -1};
}

TEST(PanelPlace, FacesTheReader) {
  const panel::PanelSite s = site();
  const Pose panel = panel::place_panel(s);
  EXPECT_GT((panel.q * Vec3::UnitZ()).dot((s.reader.eyes - panel.p).normalized()), 0.999);
  EXPECT_GT((panel.q * Vec3::UnitY()).y(), 0.5) << "upright";
  EXPECT_NEAR((panel.q * Vec3::UnitX()).y(), 0, 1e-12) << "its lines are level";
}

TEST(PanelPlace, StandsBesideThePartAndInReach) {
  for (const double side : {-1.0, 1.0}) {
    panel::PanelSite s = site();
    s.side = side;
    const Pose panel = panel::place_panel(s);
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5}) {
        const Vec3 corner = panel * Vec3(x * panel_width, y * panel_height, 0);
        EXPECT_FALSE((corner.array() > s.lo.array()).all() && (corner.array() < s.hi.array()).all());
      }
    EXPECT_LT((panel.p - s.touched).norm(), 0.5);
    const Vec3 right = Vec3::UnitY().cross(s.reader.eyes - s.touched);
    EXPECT_GT(side * right.dot(panel.p - s.touched), 0) << "on the side asked for";
  }
}

TEST(PanelPlace, LeavesThePartInSightOfWhoLooksFromAbove) {
  panel::PanelSite s = site();
  for (const double side : {-1.0, 1.0})
    for (const Vec3& reader : {Vec3(0.02, 1.9, 0.04), Vec3(0.02, 1.9, 0.3), Vec3(0.1, 1.7, 0.1)}) {
      s.side = side;
      s.reader.eyes = reader;
      const Pose panel = panel::place_panel(s);
      const Vec3 away = Vec3(s.touched.x() - reader.x(), 0, s.touched.z() - reader.z()).normalized();
      // Seen from the eyes, on the level of the part's top: all of the board is beyond all of the part.
      const auto seen = [&](const Vec3& place) {
        const double share = (reader.y() - s.hi.y()) / (reader.y() - place.y());
        return away.dot(reader + share * (place - reader));
      };
      double farthest = -1, nearest = 1;
      for (const double x : {s.lo.x(), s.hi.x()})
        for (const double z : {s.lo.z(), s.hi.z()}) farthest = std::max(farthest, seen({x, s.hi.y(), z}));
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
          nearest = std::min(nearest, seen(panel * Vec3(x * panel_width, y * panel_height, 0)));
      EXPECT_GT(nearest, farthest) << "side " << side << ", reader " << reader.transpose();
      EXPECT_LT((panel.p - s.touched).norm(), 0.5) << "in reach";
    }
}

TEST(PanelPlace, IsUprightInThePictureOfWhoLooksFromAbove) {
  for (const double angle : {0.0, 1.0, 2.5, 4.0, 5.5})
    for (const Vec3& beside : {Vec3(0, 0, 0), Vec3(0.05, 0, -0.02), Vec3(-0.04, 0, 0.03)}) {
      panel::PanelSite s = site();
      s.reader.eyes = s.touched + Vec3(0, 0.6, 0) + beside;
      s.reader.ahead = {std::sin(angle), 0, -std::cos(angle)};
      const Pose panel = panel::place_panel(s);
      EXPECT_GT((panel.p - s.touched).dot(s.reader.ahead), panel_height / 2) << "beyond the part: above it";
      Vec3 up = panel.q * Vec3::UnitY();
      up.y() = 0;
      EXPECT_GT(up.normalized().dot(s.reader.ahead), 0.97) << "angle " << angle;
      const Vec3 dragged = s.touched + Vec3(0.1, 0.05, 0.1);
      up = panel::face_reader(dragged, s.reader) * Vec3::UnitY();
      EXPECT_GT(Vec3(up.x(), 0, up.z()).normalized().dot(s.reader.ahead), 0.97) << "dragged, angle " << angle;
    }
}

TEST(PanelPlace, TurnsWithoutAJumpFromBesideToAbove) {
  panel::PanelReader reader{{0, 1.6, 0}, {-1, 0, 0}};
  Quat last = panel::face_reader({0.0, 1.0, -2}, reader);
  for (double z = -2; z <= 0.0; z += 0.001) {
    const Quat now = panel::face_reader({0.0, 1.0, z}, reader);
    ASSERT_LT(now.angularDistance(last), 0.05) << z;
    last = now;
  }
}

TEST(PanelPlace, IsAProperPoseForAnySite) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> wide(-1000, 1000), narrow(-0.1, 0.1);
  for (int i = 0; i < 2000; ++i) {
    const auto place = [&](auto& d) { return Vec3(d(random), d(random), d(random)); };
    panel::PanelSite s;
    s.touched = place(wide);
    s.reader.eyes = i % 3 == 0 ? place(wide) : i % 3 == 1 ? Vec3(s.touched + place(narrow)) : s.touched;
    if (i % 7 == 0) s.reader.eyes = s.touched + Vec3(0, 1, 0);
    const Vec3 ahead(place(narrow).x(), 0, place(narrow).z());
    if (i % 2 == 0) s.reader.ahead = ahead.normalized();
    s.lo = s.touched - place(narrow).cwiseAbs();
    s.hi = s.touched + place(narrow).cwiseAbs();
    s.side = i % 2 == 0 ? 1 : -1;
    const Pose panel = panel::place_panel(s);
    ASSERT_TRUE(is_finite(panel)) << i;
    ASSERT_NEAR(panel.q.norm(), 1, 1e-9);
    ASSERT_LT((panel.p - s.touched).norm(), 0.6);
    ASSERT_GT((panel.q * Vec3::UnitY()).y(), 0.3);
  }
}

}  // namespace
}  // namespace prosector
