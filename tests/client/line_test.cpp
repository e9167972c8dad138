// Lines of a width: never dotted, however they lie, and faint where something hides them.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "client/render/screen_quads.h"
#include "client/view/held_blades.h"
#include "tests/client/picture.h"

namespace prosector {
namespace {

using namespace test;

const std::vector<CuttingEdge> scalpel = {{{0, 0, 0.1}, {0, 0, -0.1}}};

double edge_width() {
  DrawList list;
  add_edges(list, scalpel, {});
  return list.lines.at(0).width;
}

/// Returns the brightness of a picture of a blade's edge before a dark wall, or behind it.
Image edge_before_wall(const Pose& blade, double wall) {
  DrawList list;
  list.cameras = {straight_camera({0, 0, 1}, 160, 120)};
  list.ambient = list.background = Vec3::Zero();
  DrawItem item;
  item.mesh = sphere_mesh(0.5, 1);  // its front is at `wall`
  item.pose.p = {0, 0, wall - 0.5};
  item.appearance = {{0.05, 0.01, 0.01}, 1, 0, Surface::emissive};
  list.items = {item};
  add_edges(list, scalpel, blade);
  return picture_of(list, 160, 120);
}

TEST(BladeEdge, IsNeverNarrowerOrShorterThanOneAndAHalfPixels) {
  const double width = edge_width();
  EXPECT_GE(width, 1.5);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-0.9, 0.9);
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Vector4d a(anywhere(random), anywhere(random), 0, 1);
    const Eigen::Vector4d b = k % 3 == 0 ? a : Eigen::Vector4d(anywhere(random), anywhere(random), 0, 1);
    std::vector<ScreenVertex> out;
    add_line(out, a, b, Vec3::Ones(), width, {800, 600});
    ASSERT_EQ(out.size(), 6u);
    const auto pixel = [&](std::size_t v) {
      return Eigen::Vector2d(400 * out[v].at.x(), 300 * out[v].at.y());
    };
    EXPECT_GE((pixel(1) - pixel(0)).norm(), 1.5) << "seen from its end";
    EXPECT_GE((pixel(2) - pixel(1)).norm(), 1.5);
  }
}

TEST(BladeEdge, IsSeenWithoutGapsFromEveryDirection) {
  std::mt19937 random(7);
  std::normal_distribution<double> any;
  for (int k = 0; k < 6; ++k) {
    const Quat turn = Quat(any(random), any(random), any(random), any(random)).normalized();
    const Image image = edge_before_wall({{0, 0, 0.2}, turn}, 0);
    int left = image.width, right = -1, low = image.height, high = -1;
    std::vector<char> bright(image.rgb.size() / 3, 0);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const std::size_t at = static_cast<std::size_t>(y * image.width + x);
        if (luminance(&image.rgb[3 * at]) < 120) continue;
        bright[at] = 1;
        left = std::min(left, x), right = std::max(right, x);
        low = std::min(low, y), high = std::max(high, y);
      }
    ASSERT_GE(right, left) << "not seen at all";
    // Along its longer way every column, or row, has a bright pixel.
    const bool level = right - left >= high - low;
    for (int i = level ? left : low; i <= (level ? right : high); ++i) {
      bool seen = false;
      for (int j = level ? low : left; j <= (level ? high : right); ++j)
        seen |= bright[static_cast<std::size_t>(level ? j * image.width + i : i * image.width + j)] != 0;
      EXPECT_TRUE(seen) << "a gap at " << i;
    }
  }
}

TEST(BladeEdge, ShinesFaintlyThroughWhatHidesIt) {
  const Pose across{{0, 0, 0.1}, Quat(Eigen::AngleAxisd(1.5707963, Vec3::UnitY()))};
  const auto brightest = [&](double wall) {
    const Image image = edge_before_wall(across, wall);
    double most = 0;
    for (std::size_t k = 0; k < image.rgb.size(); k += 3) most = std::max(most, luminance(&image.rgb[k]));
    return most;
  };
  const double open = brightest(0), hidden = brightest(0.2);
  EXPECT_GT(open, 150);
  EXPECT_GT(hidden, 60) << "seen";
  EXPECT_LT(hidden, 0.75 * open) << "faint";
}

}  // namespace
}  // namespace prosector
