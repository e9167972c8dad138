#include <gtest/gtest.h>

#include <functional>

#include "client/render/screen_quads.h"
#include "client/render/text_layout.h"
#include "tests/client/picture.h"

namespace prosector {
namespace {

using namespace test;

/// Cameras side by side that look along −z at texts two metres away.
DrawList texts_in_a_row(std::size_t count, double spacing, int eyes) {
  DrawList list;
  for (int eye = 0; eye < eyes; ++eye) {
    DrawCamera camera;
    camera.pose.p = Vec3(0.06 * eye, 0, 2);
    list.cameras.push_back(camera);
  }
  for (std::size_t i = 0; i < count; ++i)
    list.texts.push_back({.text = "a_long_name\n12 steps of 3 ms",
                          .at = Vec3(spacing * static_cast<double>(i), 0, 0),
                          .overlay = false,
                          .height = 11});
  return list;
}

TEST(TextLayout, NoTextInTheRoomCoversAnother) {
  Typesetter typesetter;
  for (const double spacing : {0., 0.05, 0.1, 0.15, 0.3, 1.}) {
    const DrawList list = texts_in_a_row(9, spacing, 1);
    const auto placed = place_texts(list, list.cameras[0], typesetter);
    ASSERT_EQ(placed.size(), 9u);
    EXPECT_EQ(placed[0].lift, 0) << "the first stands at its place";
    for (std::size_t i = 0; i < placed.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Eigen::Array2d low = placed[i].origin.cwiseMax(placed[j].origin),
                             high = (placed[i].origin + placed[i].size)
                                        .cwiseMin(placed[j].origin + placed[j].size);
        EXPECT_TRUE((high <= low).any()) << spacing << ": " << i << " covers " << j;
      }
    if (spacing >= 1) {
      for (const PlacedText& text : placed) EXPECT_EQ(text.lift, 0) << "there is room";
    }
  }
}

TEST(TextLayout, BothEyesLiftAlike) {
  Typesetter typesetter;
  const DrawList list = texts_in_a_row(5, 0.1, 2);
  const auto left = place_texts(list, list.cameras[0], typesetter),
             right = place_texts(list, list.cameras[1], typesetter);
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_EQ(left[i].origin.y(), right[i].origin.y());
    EXPECT_GT(left[i].origin.x(), right[i].origin.x()) << "parallax";
  }
  EXPECT_GT(left[1].lift, 0);
}

TEST(TextLayout, LeavesTheOverlayAndWhatIsBehindTheEyeAlone) {
  Typesetter typesetter;
  DrawList list = texts_in_a_row(2, 0, 1);
  list.texts[0].at.z() = 5;
  list.texts.push_back({.text = "x", .at = {400, 300, 0}});
  const auto placed = place_texts(list, list.cameras[0], typesetter);
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_EQ(placed[0].lift, 0);
  EXPECT_EQ(placed[1].origin, Eigen::Vector2d(400, 300));
}

TEST(TextLayout, OnAFinerDisplayEverythingIsAsManyPixelsLarger) {
  Typesetter typesetter;
  DrawList list = texts_in_a_row(3, 0.1, 1);
  list.texts.push_back({.text = "x", .at = {400, 300, 0}});
  const auto usual = place_texts(list, list.cameras[0], typesetter);
  list.scale = 2;
  list.cameras[0].width *= 2;
  list.cameras[0].height *= 2;
  const auto fine = place_texts(list, list.cameras[0], typesetter);
  ASSERT_EQ(fine.size(), usual.size());
  for (std::size_t i = 0; i < fine.size(); ++i) {
    EXPECT_LT((fine[i].origin - 2 * usual[i].origin).norm(), 3) << i << ": rounded to pixels";
    EXPECT_LT((fine[i].size - 2 * usual[i].size).norm(), 1e-9) << i;
  }
}

TEST(ScreenQuads, AreAsWideAsAskedInPixels) {
  std::vector<ScreenVertex> out;
  const Viewport viewport{400, 200};
  add_line(out, {0, -0.5, 0, 1}, {0, 0.5, 0, 1}, Vec3::Ones(), 4, viewport);
  ASSERT_EQ(out.size(), 6u);
  float left = 1, right = -1;
  for (const ScreenVertex& v : out) {
    left = std::min(left, v.at.x());
    right = std::max(right, v.at.x());
  }
  EXPECT_NEAR((right - left) * 200, 4, 1e-5);
}

TEST(ScreenQuads, CutOffWhatIsBehindTheEye) {
  std::vector<ScreenVertex> out;
  const Viewport viewport{100, 100};
  add_line(out, {0, 0, -2, -1}, {0, 0, -3, -2}, Vec3::Ones(), 2, viewport);
  EXPECT_TRUE(out.empty());
  add_line(out, {0, 0, -2, -1}, {0.5, 0, 0.9, 1}, Vec3::Ones(), 2, viewport);
  EXPECT_EQ(out.size(), 6u);
  for (const ScreenVertex& v : out) EXPECT_TRUE(v.at.allFinite());
}

int pixels_where(const Image& image, const std::function<bool(double)>& luminance_is) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += luminance_is(luminance(image.pixel(x, y))) ? 1 : 0;
  return count;
}

TEST(Text, IsLegibleOnAnyGround) {
  for (const double ground : {0.0, 0.5, 1.0}) {
    DrawList list;
    list.cameras = {straight_camera({0, 0, 1}, 120, 36)};
    list.background = Vec3::Constant(ground);
    list.texts = {{"Prosector", {10, 8, 0}, true, 16, {1, 1, 1}}};
    const Image image = picture_of(list, 120, 36);
    EXPECT_GT(pixels_where(image, [](double l) { return l > 220; }), 100) << ground;
    const Image part = picture_of(list, 120, 36);
    int dim = 0;
    for (int x = 8; x < 88; ++x) dim += luminance(part.pixel(x, 9)) < 170 ? 1 : 0;
    EXPECT_GT(dim, 60) << ground << ": the plate above the letters is darker than they are";
  }
}

TEST(Text, WithoutAGroundLeavesThePictureAloneBetweenItsLetters) {
  DrawList list;
  list.cameras = {straight_camera({0, 0, 1}, 120, 36)};
  list.background = Vec3::Ones();
  list.texts = {{.text = "l l", .at = {10, 8, 0}, .height = 16, .color = Vec3::Zero()}};
  list.texts[0].ground = TextGround::none;
  const Image image = picture_of(list, 120, 36);
  EXPECT_GT(pixels_where(image, [](double l) { return l < 60; }), 8);
  EXPECT_GT(pixels_where(image, [](double l) { return l > 250; }), 120 * 36 - 100);
}

/// Writing on a wall, seen from `distance` metres by an eye of 400 × 300 pixels.
DrawList writing_seen_from(double distance, const std::string& text, double height) {
  DrawList list;
  list.cameras = {straight_camera({0, 0, distance}, 400, 300)};
  list.background = Vec3::Zero();
  DrawText writing{.text = text, .height = height, .color = Vec3::Ones()};
  writing.surface = Pose{};
  writing.centred = true;
  list.texts = {writing};
  return list;
}

// A bar with a border as sharp as the picture allows has, beside its inside and outside, one pixel across its
// border at most: so few pixels in between for its length.
TEST(Text, OnSurfacesIsSharpFromAnyDistance) {
  for (const double distance : {0.2, 0.5, 1.0, 2.0}) {
    const DrawList list = writing_seen_from(distance, "I", 0.1);
    const double letter = 0.73 * 0.1 * 300 / (0.8 * distance);  // pixels, the height of a capital
    const Image image = picture_of(list, 400, 300);
    const int inside = pixels_where(image, [](double l) { return l > 230; });
    const int between = pixels_where(image, [](double l) { return l > 25 && l <= 230; });
    const double width = 0.134 * letter;  // a stem's
    EXPECT_NEAR(inside + 0.5 * between, letter * width, 0.15 * letter * width + 4) << distance;
    EXPECT_LT(between, 2 * (letter + width) + 8) << distance;
  }
}

TEST(Text, OnSurfacesNeedsNoLamp) {
  DrawList list = writing_seen_from(0.5, "I", 0.1);
  RendererSettings no_dust;
  no_dust.effects[index_of(Effect::shafts)] = false;
  const Image dark = picture_of(list, 400, 300, make_offscreen_context, no_dust);
  list.lights = {lamp({0, 0.2, 0.5}, Vec3::Zero())};
  list.ambient = Vec3::Ones();
  EXPECT_TRUE(dark == picture_of(list, 400, 300, make_offscreen_context, no_dust));
}

TEST(Text, OnSurfacesIsHiddenByWhatStandsBefore) {
  DrawList list = writing_seen_from(0.5, "I", 0.1);
  DrawItem ball;
  ball.mesh = sphere_mesh(0.1, 1);
  ball.pose.p = {0, 0, 0.15};
  ball.appearance.color = Vec3::Zero();
  ball.appearance.roughness = 1;
  list.items = {ball};
  EXPECT_EQ(pixels_where(picture_of(list, 400, 300), [](double l) { return l > 200; }), 0);
}

// More glyphs than a sheet holds: it is drawn in parts, and nothing is lost.
TEST(Text, DrawsEverythingWhenTheSheetOverflows) {
  DrawList list;
  list.cameras = {straight_camera({0, 0, 1}, 640, 480)};
  list.background = Vec3::Zero();
  const auto add = [&](double height, double y) {
    DrawText text{.text = "Wxyz", .at = {10, y, 0}, .height = height};
    text.ground = TextGround::none;
    list.texts.push_back(text);
  };
  add(30, 5);
  const Image alone = picture_of(list, 640, 480);
  list.texts.clear();
  for (int k = 0; k < 200; ++k) add(120 + 0.1 * k, 90);
  list.texts.insert(list.texts.begin(), DrawText{.text = "Wxyz", .at = {10, 5, 0}, .height = 30});
  list.texts[0].ground = TextGround::none;
  add(30, 300);
  const Image many = picture_of(list, 640, 480);
  for (int y = 5; y < 45; ++y)
    for (int x = 0; x < 200; ++x) {
      ASSERT_EQ(luminance(many.pixel(x, y)), luminance(alone.pixel(x, y))) << x << ", " << y;
      ASSERT_EQ(luminance(many.pixel(x, y + 295)), luminance(alone.pixel(x, y))) << x << ", " << y;
    }
}

// Both are Mesa's rasteriser, and FreeType draws the same for both.
TEST(Text, EglAndOsMesaDrawTheSameBytesOfAnyScript) {
  DrawList list = writing_seen_from(0.5, "Leber karaciğer ήπαρ печень", 0.02);
  list.scale = 1.5;
  list.texts.push_back({"الكبد 12 כבד\nयकृत 肝脏 \xff", {10, 10, 0}});
  list.texts.push_back({.text = "framed", .at = {0, 0.1, 0}, .overlay = false});
  list.texts.back().ground = TextGround::framed;
  EXPECT_TRUE(picture_of(list, 400, 300, make_egl_context) ==
              picture_of(list, 400, 300, make_osmesa_context));
}

}  // namespace
}  // namespace prosector
