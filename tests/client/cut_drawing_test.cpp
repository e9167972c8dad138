// A blade that a desk user draws over an organ: it follows the pointer's way at the depth that is set.

#include "client/app/desk/cut_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace prosector {
namespace {

constexpr double picture_seconds = 0.02;  // s
constexpr BodyId organ = 3;

/// A ball around a centre; so large a one is a plane.
struct Ball {
  Vec3 centre;
  double radius;

  std::optional<Picked> meet(const Ray& ray) const {
    const Vec3 from = ray.from - centre;
    const double half = from.dot(ray.along), beyond = from.squaredNorm() - radius * radius;
    const double root = half * half - beyond;
    if (root < 0 || beyond < 0 || half > 0) return std::nullopt;
    const double distance = -half - std::sqrt(root);
    const Vec3 at = ray.from + distance * ray.along;
    return Picked{{distance, at, (at - centre).normalized()}, organ};
  }
  double depth(const Vec3& x) const { return radius - (x - centre).norm(); }
};

class DrawnCut : public testing::Test {
 protected:
  Ball ball{{0, 0.9, 0}, 0.1};
  CutDrawing drawing;
  CutGuide guide;
  Pose wrist{{0, 1.2, 0.3}, Quat::Identity()};
  std::vector<Vec3> tips;  // while it cuts
  std::vector<Pose> wrists;

  void SetUp() override {
    guide.blade = {{0.01, -0.02, -0.28}, -Vec3::UnitZ(), -Vec3::UnitX(), 0.1};
    guide.find = [this](const Ray& ray, std::optional<BodyId>) { return ball.meet(ray); };
  }
  void picture(double seconds = picture_seconds) {
    guide.physical = wrist;
    if (const auto led = drawing.advance(guide, wrist, seconds)) {
      EXPECT_LT((led->p - wrist.p).norm(), 0.12) << "a jump";
      wrist = *led;
      const Vec3 tip = wrist * guide.blade.tip;
      if (ball.depth(tip) > 0) {
        tips.push_back(tip);
        wrists.push_back(wrist);
      }
    }
  }
  void wait(double seconds) {
    for (double t = 0; t < seconds; t += picture_seconds) picture();
  }
  /// Points at the ball from above.
  void point(double x, double z) { guide.tissue = ball.meet({{x, 2, z}, -Vec3::UnitY()}); }
  /// Draws from one end of a line to the other with the button down, and waits until the cut is done.
  void draw(double from, double to, double z = 0) {
    point(from, z);
    drawing.press();
    wait(0.1);
    for (int k = 0; k <= 60; ++k) {
      point(from + (to - from) * k / 60, z);
      picture();
    }
    wait(0.5);
    drawing.release();
    wait(4);
  }
  /// Expects the cut's middle at its depth; at its ends the blade goes in and out.
  void expect_depth(double depth, double tolerance) const {
    ASSERT_GT(tips.size(), 20u);
    std::size_t deep = 0;
    for (const Vec3& tip : tips) {
      EXPECT_LT(ball.depth(tip), depth + tolerance);
      if (ball.depth(tip) > depth - tolerance) ++deep;
    }
    EXPECT_GT(static_cast<double>(deep), 0.5 * static_cast<double>(tips.size()));
  }
};

TEST_F(DrawnCut, KeepsItsDepthInAPlane) {
  ball = {{0, -1000, 0}, 1001};
  draw(-0.1, 0.1);
  expect_depth(first_cut_depth, 0.0002);
  EXPECT_LT(tips.front().x(), -0.095);
  EXPECT_GT(tips.back().x(), 0.095) << "as far as the pointer went";
}

TEST_F(DrawnCut, KeepsItsDepthInABall) {
  drawing.deepen(5);
  draw(-0.07, 0.07);
  expect_depth(0.015, 0.0015);
}

TEST_F(DrawnCut, ItsTipStaysUnderAWindingWay) {
  ball = {{0, -1000, 0}, 1001};
  const auto way = [](double s) { return 0.02 * std::sin(s / 0.03); };
  point(0, way(0));
  drawing.press();
  for (double s = 0; s <= 0.12; s += 0.001) {
    point(s, way(s));
    picture();
  }
  drawing.release();
  wait(4);
  ASSERT_GT(tips.size(), 20u);
  for (const Vec3& tip : tips) EXPECT_NEAR(tip.z(), way(tip.x()), 0.002);
}

TEST_F(DrawnCut, ItsTipStaysUnderAWayThatThePointerWentBetweenTwoPictures) {
  ball = {{0, -1000, 0}, 1001};
  const auto way = [](double s) { return 0.02 * std::sin(s / 0.03); };
  picture();
  point(0, way(0));
  drawing.press();
  for (double s = 0; s <= 0.12; s += 0.001) {
    point(s, way(s));
    drawing.trace(*guide.tissue, guide.find);
  }
  drawing.release();
  EXPECT_TRUE(drawing.is_on_tissue());
  wait(4);
  ASSERT_GT(tips.size(), 20u);
  for (const Vec3& tip : tips) EXPECT_NEAR(tip.z(), way(tip.x()), 0.002);
  EXPECT_GT(tips.back().x(), 0.115) << "as far as it went before the button went up";
}

TEST_F(DrawnCut, GoesOnOverRimsThatThePointerCrossesAndEndsWhereTheButtonGoesUpOnTissue) {
  for (const bool beside : {true, false}) {
    ball = {{0, -1000, 0}, 1001};
    tips.clear();
    drawing = {};
    const auto at = [&](double x) {
      point(x, 0);
      if (beside && std::abs(x) > 0.05) guide.tissue.reset();
    };
    at(beside ? -0.06 : -0.05);
    drawing.press();
    for (int k = 0; k <= 120; ++k) {
      at((beside ? 0.06 : 0.05) * (k / 60.0 - 1));
      picture();
    }
    drawing.release();
    for (int k = 0; k < 200; ++k) picture();
    ASSERT_FALSE(tips.empty());
    double first = 0, last = 0;
    for (const Vec3& tip : tips) first = std::min(first, tip.x()), last = std::max(last, tip.x());
    const double beyond = beside ? 0.008 : 0;
    EXPECT_NEAR(last, 0.05 + beyond, 0.0035) << beside;
    EXPECT_NEAR(first, -0.05 - beyond, 0.0035) << beside;
  }
}

TEST_F(DrawnCut, ALatePictureLeadsItNoFartherThanATenthOfASecondDoes) {
  ball = {{0, -1000, 0}, 1001};
  picture();
  for (double x = -0.1; x <= 0.1; x += 0.003) {
    point(x, 0);
    x == -0.1 ? drawing.press() : drawing.trace(*guide.tissue, guide.find);
    if (x == -0.1) picture();
  }
  drawing.release();
  double farthest = 0, most_turned = 0;
  int pictures = 0;
  for (; pictures < 100 && (pictures < 3 || drawing.leads()); ++pictures) {
    const Pose before = wrist;
    picture(0.9);
    farthest = std::max(farthest, (wrist * guide.blade.tip - before * guide.blade.tip).norm());
    most_turned = std::max(most_turned, wrist.q.angularDistance(before.q));
  }
  EXPECT_LT(pictures, 60) << "late as they are";
  EXPECT_LT(farthest, 0.051);
  EXPECT_LT(most_turned, 0.26);
  ASSERT_GT(tips.size(), 10u);
  EXPECT_GT(tips.back().x(), 0.09);
}

TEST_F(DrawnCut, TurnsFarOnlyHighOverTissue) {
  ball = {{0, -1000, 0}, 1001};
  wrist.p = {0, 1.06, 0.3};  // its tip 4 cm up, the blade level
  const Quat level = wrist.q;
  point(-0.05, 0);
  drawing.press();
  std::vector<Pose> way;
  for (int k = 0; k <= 300 && tips.empty(); ++k) {
    point(-0.05 + 0.1 * std::min(k / 60.0, 1.0), 0);
    picture();
    way.push_back(wrist);
  }
  ASSERT_FALSE(tips.empty());
  EXPECT_GT(level.angularDistance(wrist.q), 1);
  double lowest = 1;
  for (const Pose& at : way)
    if (at.q.angularDistance(level) > 0.6 && at.q.angularDistance(wrist.q) > 0.6)
      lowest = std::min(lowest, (at * guide.blade.tip).y() - 1);
  EXPECT_GT(lowest, 0.08);
  EXPECT_LT(lowest, 1) << "it was seen to turn";
}

TEST_F(DrawnCut, TheBladeLiesInThePlaneOfTheWayWithItsEdgeAhead) {
  draw(-0.05, 0.05);
  ASSERT_FALSE(wrists.empty());
  const Pose& middle = wrists[wrists.size() / 2];
  const BladeFrame blade = middle * guide.blade;
  EXPECT_NEAR(blade.along.z(), 0, 0.02);
  EXPECT_NEAR(blade.ahead.z(), 0, 0.02);
  EXPECT_GT(blade.ahead.x(), 0.8);
  EXPECT_LT(blade.along.y(), -0.8) << "the tip is down";
}

TEST_F(DrawnCut, AFastPointerIsFollowedOverTheSurfaceBetween) {
  point(-0.06, 0);
  drawing.press();
  picture();
  point(0.06, 0);
  wait(0.1);
  drawing.release();
  wait(4);
  expect_depth(first_cut_depth, 0.001);
}

TEST_F(DrawnCut, LeavingTheOrganEndsIt) {
  point(0, 0);
  drawing.press();
  picture();
  point(0.03, 0);
  wait(0.2);
  guide.tissue.reset();
  wait(3);
  EXPECT_FALSE(drawing.advance(guide, wrist, picture_seconds))
      << "the hand is its own again, the button still down";
  const std::size_t cut = tips.size();
  point(-0.03, 0);
  wait(2);
  EXPECT_EQ(tips.size(), cut) << "the next cut takes another press";
  EXPECT_GT(ball.depth(wrist * guide.blade.tip), -0.05);
  EXPECT_LT(ball.depth(wrist * guide.blade.tip), 0) << "it is out";
}

TEST_F(DrawnCut, APressThatGoesNowhereCutsNothing) {
  point(0, 0);
  drawing.press();
  wait(2);
  EXPECT_TRUE(drawing.is_on_tissue());
  drawing.release();
  wait(1);
  EXPECT_TRUE(tips.empty());
}

TEST_F(DrawnCut, TheWheelSetsTheDepthWhileItCuts) {
  ball = {{0, -1000, 0}, 1001};
  point(-0.1, 0);
  drawing.press();
  for (int k = 0; k <= 150; ++k) {
    point(-0.1 + 0.1 * k / 150, 0);
    picture();
  }
  drawing.deepen(-6);
  for (int k = 0; k <= 150; ++k) {
    point(0.1 * k / 150, 0);
    picture();
  }
  drawing.release();
  EXPECT_NEAR(ball.depth(wrist * guide.blade.tip), 0.004, 1e-4);
  EXPECT_NEAR(drawing.depth(), 0.004, 1e-12);
  drawing.deepen(-100);
  EXPECT_DOUBLE_EQ(drawing.depth(), least_cut_depth);
}

TEST_F(DrawnCut, NoDeeperThanTheBladeIsLong) {
  ball = {{0, -1000, 0}, 1001};
  guide.blade.length = 0.04;
  drawing.deepen(40);
  draw(-0.05, 0.05);
  for (const Vec3& tip : tips) EXPECT_LT(ball.depth(tip), 0.04);
}

TEST_F(DrawnCut, WhereItWouldCutIsALineOnTheSurface) {
  point(0.02, 0);
  picture();
  point(0.02, 0.01);
  picture();
  const std::vector<Vec3> line = drawing.line(guide);
  ASSERT_GT(line.size(), 4u);
  for (const Vec3& x : line) {
    EXPECT_NEAR(ball.depth(x), -0.001, 5e-4);
    EXPECT_NEAR(x.x(), 0.02, 0.004) << "along the pointer's way";
  }
  guide.tissue.reset();
  EXPECT_TRUE(drawing.line(guide).empty());
}

}  // namespace
}  // namespace prosector
