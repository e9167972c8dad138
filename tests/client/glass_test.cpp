// Glass against the closed forms of plates and balls.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "client/render/refraction.h"
#include "tests/client/picture.h"

namespace prosector {
namespace {

using namespace test;

constexpr int side = 200;  // pixels; the camera sees 0.8 m at 1 m

/// A renderer keeps meshes by their ids.
std::uint64_t next_id() {
  static std::uint64_t last = 0;
  return ++last;
}

std::shared_ptr<DrawMesh> mesh_of_box(const Vec3& size) {
  PartDesc part;
  part.size = size;
  const TriangleMesh box = mesh_of(part);
  auto out = std::make_shared<DrawMesh>();
  out->id = next_id();
  for (const auto& t : box.triangles) {
    const Vec3 &a = box.positions[t[0]], &b = box.positions[t[1]], &c = box.positions[t[2]];
    const auto first = static_cast<std::uint32_t>(out->positions.size());
    for (const Vec3& x : {a, b, c}) {
      out->positions.push_back(x.cast<float>());
      out->normals.push_back((b - a).cross(c - a).normalized().cast<float>());
    }
    out->triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

/// A backdrop at z = −1 that shines: left of x = 0 in one colour, right of it in another. No other light, so
/// that glass mirrors nothing.
DrawList backdrop(const Vec3& left, const Vec3& right) {
  DrawList list;
  list.cameras = {straight_camera({0, 0, 1}, side, side)};
  list.ambient = list.background = Vec3::Zero();
  for (const double x : {-1.0, 1.0}) {
    DrawItem item;
    item.mesh = mesh_of_box({2, 4, 0.02});
    item.pose.p = {x, 0, -1.01};
    item.appearance = {x < 0 ? left : right, 1, 0, Surface::emissive};
    list.items.push_back(item);
  }
  return list;
}

void add_glass(DrawList& list, std::shared_ptr<DrawMesh> mesh, const Pose& pose, double index,
               const Vec3& transmittance = Vec3::Ones()) {
  DrawItem item;
  item.mesh = std::move(mesh);
  item.pose = pose;
  item.appearance.surface = Surface::glass;
  item.appearance.roughness = 0.05;
  item.appearance.refractive_index = index;
  item.appearance.transmittance = transmittance;
  list.items.push_back(item);
}

/// Renderers take long to make: one for each set of effects.
class Glass : public testing::Test {
 protected:
  static Image draw(const DrawList& list, bool refraction = true, bool dispersion = false) {
    if (!context_) context_ = make_offscreen_context(side, side);
    std::unique_ptr<Renderer>& renderer = renderers_[{refraction, dispersion}];
    if (!renderer) {
      RendererSettings settings;
      settings.effects[index_of(Effect::refraction)] = refraction;
      settings.effects[index_of(Effect::dispersion)] = dispersion;
      settings.effects[index_of(Effect::edges)] = false;
      renderer = std::make_unique<Renderer>(*context_, default_shader_dir(), settings);
    }
    renderer->draw(list);
    return renderer->read_pixels();
  }
  static void TearDownTestSuite() {
    renderers_.clear();
    context_.reset();
  }

 private:
  static inline std::unique_ptr<GlContext> context_;
  static inline std::map<std::pair<bool, bool>, std::unique_ptr<Renderer>> renderers_;
};

/// Where, along the row, the picture turns from darker to brighter in a channel, in pixels. Near its border
/// glass shows what lies outside of the picture: the room, which is dark.
double step_at(const Image& image, int row, std::size_t channel) {
  constexpr int margin = 50;
  const double middle = (image.pixel(margin, row)[channel] + image.pixel(side - margin, row)[channel]) / 2.0;
  for (int x = margin + 1; x < side - margin; ++x) {
    const double before = image.pixel(x - 1, row)[channel], here = image.pixel(x, row)[channel];
    if (before < middle && here >= middle) return x - 0.5 + (middle - before) / (here - before);
  }
  return NAN;
}

TEST_F(Glass, IndicesFollowCauchyWithTheAbbeNumber) {
  Appearance crown;
  const Vec3 n = refractive_indices(crown);
  // Schott's BK7 at 611, 549 and 464 nm, by its Sellmeier formula.
  EXPECT_NEAR(n.x(), 1.51586, 5e-4);
  EXPECT_NEAR(n.y(), 1.51852, 5e-4);
  EXPECT_NEAR(n.z(), 1.52402, 5e-4);
  crown.abbe_number = max_abbe_number;
  EXPECT_NEAR(refractive_indices(crown).z(), crown.refractive_index, 1e-3);
}

TEST_F(Glass, OfTheAirsIndexIsNotSeen) {
  DrawList list = backdrop({0.1, 0.3, 0.1}, {0.6, 0.2, 0.5});
  const Image without = draw(list);
  add_glass(list, sphere_mesh(0.2, next_id()), {}, 1);
  const Image with = draw(list);
  int worst = 0;
  for (std::size_t k = 0; k < with.rgb.size(); ++k)
    worst = std::max(worst, std::abs(with.rgb[k] - without.rgb[k]));
  EXPECT_LE(worst, 9) << "sRGB is undone to within 7 near black";
}

/// Returns by how many pixels a plate moves the step behind it for a camera 5 m away with tangents of 0.02,
/// by the law of refraction. A plate of thickness d, turned by θ, moves the ray by d sin θ (1 − cos θ / (n
/// cos θ')).
double pixels_moved(double d, double angle, double n) {
  const double sine = std::sin(angle) / n;
  const double shift = d * std::sin(angle) * (1 - std::cos(angle) / (n * std::sqrt(1 - sine * sine)));
  // Beside the axis by the angle a, the ray is 5 m · a off it at the plate and meets x = 0 after another
  // metre.
  return shift / 6 * (side / 0.04);
}

TEST_F(Glass, APlateMovesWhatIsBehindItByTheLawOfRefraction) {
  constexpr double d = 0.1, n = 1.6;
  const double before = step_at(draw(backdrop(Vec3::Constant(0.1), Vec3::Constant(0.8))), side / 2, 1);
  EXPECT_NEAR(before, side / 2.0, 0.6);
  for (const double angle : {0.3, 0.6, -0.6}) {
    DrawList list = backdrop(Vec3::Constant(0.1), Vec3::Constant(0.8));
    // Far away and through a long lens, rays are nearly parallel.
    list.cameras = {straight_camera({0, 0, 5}, side, side, 0.02)};
    add_glass(list, mesh_of_box({0.8, 0.8, d}), {{0, 0, 0}, Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()))},
              n);
    const double pixels = pixels_moved(d, angle, n);
    EXPECT_NEAR(step_at(draw(list), side / 2, 1) - side / 2.0, pixels, 0.04 * std::abs(pixels) + 0.7)
        << angle;
  }
}

TEST_F(Glass, ABallTurnsThePictureRound) {
  DrawList list = backdrop({0.8, 0.05, 0.05}, {0.05, 0.05, 0.8});
  add_glass(list, sphere_mesh(0.2, next_id()), {}, 1.52);
  const Image image = draw(list);
  const std::uint8_t *left = image.pixel(side / 2 - 15, side / 2),
                     *right = image.pixel(side / 2 + 15, side / 2);
  EXPECT_GT(left[2], left[0] + 60) << "the right one's blue";
  EXPECT_GT(right[0], right[2] + 60);
  const Image straight = draw(list, false);
  EXPECT_GT(straight.pixel(side / 2 - 15, side / 2)[0], straight.pixel(side / 2 - 15, side / 2)[2] + 60);
}

// Of colour c the share t^(d/10 mm) is left: seen as a backdrop of that colour would be.
TEST_F(Glass, SwallowsByItsThickness) {
  const Vec3 shade(0.5, 0.4, 0.6), t(0.9, 0.7, 0.5);
  DrawList list = backdrop(shade, shade);
  add_glass(list, mesh_of_box({0.3, 0.3, 0.02}), {}, 1, t);
  const Image tinted = draw(list);
  const Vec3 left = shade.cwiseProduct(t.cwiseProduct(t));
  const Image expected = draw(backdrop(left, left));
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(tinted.pixel(side / 2 + 9, side / 2)[c], expected.pixel(side / 2 + 9, side / 2)[c], 4) << c;
}

TEST_F(Glass, BendsBlueMoreThanRedIfItDisperses) {
  constexpr double d = 0.1, angle = 0.6;
  DrawList list = backdrop(Vec3::Constant(0.1), Vec3::Constant(0.8));
  list.cameras = {straight_camera({0, 0, 5}, side, side, 0.02)};
  add_glass(list, mesh_of_box({0.8, 0.8, d}), {{0, 0, 0}, Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()))},
            1.7);
  list.items.back().appearance.abbe_number = min_abbe_number;
  const Vec3 n = refractive_indices(list.items.back().appearance);
  const double expected = pixels_moved(d, angle, n.z()) - pixels_moved(d, angle, n.x());
  const Image apart = draw(list, true, true), together = draw(list, true, false);
  const double red = step_at(apart, side / 2, 0), blue = step_at(apart, side / 2, 2);
  EXPECT_GT(expected, 1);
  EXPECT_NEAR(blue - red, expected, 0.1 * expected) << red << " " << blue;
  EXPECT_NEAR(step_at(together, side / 2, 0), step_at(together, side / 2, 2), 0.05);
}

TEST_F(Glass, BehindGlassIsSeenThroughBoth) {
  DrawList list = backdrop(Vec3::Constant(0.5), Vec3::Constant(0.5));
  const Vec3 t(0.5, 1, 1);
  add_glass(list, mesh_of_box({0.3, 0.3, 0.01}), {{0, 0, 0.2}, Quat::Identity()}, 1, t);
  add_glass(list, mesh_of_box({0.3, 0.3, 0.01}), {{0, 0, -0.2}, Quat::Identity()}, 1, t);
  const Image image = draw(list);
  const Image expected = draw(backdrop({0.125, 0.5, 0.5}, {0.125, 0.5, 0.5}));
  EXPECT_NEAR(image.pixel(side / 2 + 5, side / 2)[0], expected.pixel(side / 2 + 5, side / 2)[0], 5);
}

TEST(GlassContexts, EglAndOsMesaDrawTheSameBytes) {
  DrawList list = backdrop({0.8, 0.05, 0.05}, {0.05, 0.05, 0.8});
  list.ambient = Vec3::Constant(0.1);
  list.lights = {lamp({0.5, 1, 1}, Vec3::Zero())};
  add_glass(list, sphere_mesh(0.2, next_id()), {}, 1.52);
  EXPECT_EQ(picture_of(list, side, side, make_egl_context).rgb,
            picture_of(list, side, side, make_osmesa_context).rgb);
  const RendererSettings sampled{.samples = 4};
  EXPECT_EQ(picture_of(list, side, side, make_egl_context, sampled).rgb,
            picture_of(list, side, side, make_osmesa_context, sampled).rgb);
}

}  // namespace
}  // namespace prosector
