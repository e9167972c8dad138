// What ambient occlusion leaves of the light, place by place, on a table with a step on it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "tests/client/picture.h"

namespace prosector {
namespace {

using namespace test;

constexpr int width = 240, height = 180;

constexpr std::array<double, 5> face_brightness = {0.6, 0.3, 0.15, 0.08,
                                                   0.04};  // table; step's top and sides

/// A face between four corners that go round it counter-clockwise, of even brightness.
DrawItem face(const std::array<Vec3, 4>& corners, std::size_t which) {
  auto quad = std::make_shared<DrawMesh>();
  quad->id = which + 1;
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  for (const Vec3& corner : corners) quad->positions.push_back(corner.cast<float>());
  quad->normals.assign(4, normal.cast<float>());
  quad->triangles = {{0, 1, 2}, {0, 2, 3}};
  DrawItem item;
  item.mesh = quad;
  item.appearance.color = Vec3::Constant(face_brightness[which]);
  item.appearance.surface = Surface::emissive;
  item.casts_shadow = false;
  return item;
}

/// A table and a step on it, 5 cm high, seen from above at a slant. Each face has a brightness of its own.
DrawList table_with_step(double yaw) {
  DrawList list;
  list.cameras = {straight_camera({0, 0.45, 0.62}, width, height, 0.35)};
  list.cameras[0].pose.q = Quat(Eigen::AngleAxisd(-0.6, Vec3::UnitX()));
  const Mat3 turned = Eigen::AngleAxisd(yaw, Vec3::UnitY()).toRotationMatrix();
  const auto at = [&](double x, double y, double z) -> Vec3 { return turned * Vec3(x, y, z); };
  const double x = 0.12, z = 0.08, top = 0.05;
  list.items = {
      face({Vec3(-2, 0, 2), Vec3(2, 0, 2), Vec3(2, 0, -2), Vec3(-2, 0, -2)}, 0),
      face({at(-x, top, z), at(x, top, z), at(x, top, -z), at(-x, top, -z)}, 1),
      face({at(-x, 0, z), at(x, 0, z), at(x, top, z), at(-x, top, z)}, 2),
      face({at(-x, 0, -z), at(-x, 0, z), at(-x, top, z), at(-x, top, -z)}, 3),
      face({at(x, 0, z), at(x, 0, -z), at(x, top, -z), at(x, top, z)}, 4),
  };
  return list;
}

/// Brightness of each pixel, row by row.
std::vector<double> brightness(const DrawList& list, bool occlusion, int coarser) {
  RendererSettings settings;
  settings.ambient_occlusion_pixels = coarser;
  settings.effects[index_of(Effect::edges)] = false;
  settings.effects[index_of(Effect::ambient_occlusion)] = occlusion;
  const Image image = picture_of(list, width, height, make_offscreen_context, settings);
  std::vector<double> out;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) out.push_back(luminance(image.pixel(x, y)));
  return out;
}

/// A picture's openness: brightness with ambient occlusion over that without, which also tells the faces.
struct Openness {
  std::vector<double> open;
  std::vector<int> face;  // by its brightness: any two are a factor of 1.2 apart
  Openness(const DrawList& list, int coarser) : open(brightness(list, true, coarser)) {
    const std::vector<double> plain = brightness(list, false, coarser);
    for (std::size_t k = 0; k < open.size(); ++k) {
      open[k] /= plain[k];
      face.push_back(static_cast<int>(std::lround(std::log(plain[k]) / std::log(1.1))));
    }
  }
  static std::size_t at(int x, int y) { return static_cast<std::size_t>(y * width + x); }
  /// Returns what a quarter of the same face within some pixels is lighter than; nullopt: it is too narrow
  /// there to say.
  std::optional<double> light_around(int x, int y, int within) const {
    std::vector<double> near;
    for (int b = std::max(y - within, 0); b <= std::min(y + within, height - 1); ++b)
      for (int a = std::max(x - within, 0); a <= std::min(x + within, width - 1); ++a)
        if (std::abs(face[at(a, b)] - face[at(x, y)]) <= 1) near.push_back(open[at(a, b)]);
    if (near.size() < 36) return std::nullopt;
    const auto quarter = near.end() - 1 - static_cast<std::ptrdiff_t>(near.size() / 4);
    std::nth_element(near.begin(), quarter, near.end());
    return *quarter;
  }
};

class Step : public testing::TestWithParam<int> {};

// Light fades evenly towards a crease. So nowhere is a pixel lighter than three quarters of its face around
// it.
TEST_P(Step, LeavesNoPixelLighterThanItsSurroundings) {
  for (const double yaw : {0.0, 0.3, 0.8}) {
    const Openness seen(table_with_step(yaw), GetParam());
    double lighter = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (const auto usual = seen.light_around(x, y, 4))
          lighter = std::max(lighter, seen.open[Openness::at(x, y)] - *usual);
    EXPECT_LT(lighter, 0.01) << "yaw " << yaw;
  }
}

TEST_P(Step, LeavesNoDarkRimOnItsTop) {
  for (const double yaw : {0.0, 0.3, 0.8}) {
    const Openness seen(table_with_step(yaw), GetParam());
    const int top = seen.face[Openness::at(width / 2, height / 2 - 7)];
    double darkest = 1;
    for (std::size_t k = 0; k < seen.open.size(); ++k)
      if (std::abs(seen.face[k] - top) <= 1) darkest = std::min(darkest, seen.open[k]);
    EXPECT_GT(darkest, 0.95) << "yaw " << yaw;
  }
}

TEST_P(Step, DarkensTheTableAtItsFootAndLeavesTheRestOpen) {
  const Openness seen(table_with_step(0), GetParam());
  const int table = seen.face[0];
  double darkest = 1;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (std::abs(seen.face[Openness::at(x, y)] - table) <= 1)
        darkest = std::min(darkest, seen.open[Openness::at(x, y)]);
  EXPECT_LT(darkest, 0.85);
  for (int x = 0; x < width; ++x) {
    EXPECT_NEAR(seen.open[Openness::at(x, height - 3)], 1, 0.01) << x;
    EXPECT_NEAR(seen.open[Openness::at(x, 3)], 1, 0.01) << x;
  }
}

INSTANTIATE_TEST_SUITE_P(AmbientOcclusion, Step, testing::Values(1, 2), [](const auto& coarser) {
  return coarser.param == 1 ? "ForEachPixel" : "ForFourPixelsAtOnce";
});

}  // namespace
}  // namespace prosector
