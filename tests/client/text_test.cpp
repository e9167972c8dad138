#include <gtest/gtest.h>

#include <set>

#include "client/render/screen_quads.h"
#include "client/render/stroke_font.h"
#include "client/render/text_layout.h"
#include "tests/client/picture.h"

namespace prosector {
namespace {

using namespace test;

TEST(StrokeFont, EveryGlyphIsDrawnInsideItsCellAndUnlikeAnyOther) {
  constexpr double height = 16;
  std::set<std::vector<double>> shapes;
  for (char c = '!'; c <= '~'; ++c) {
    const auto strokes = strokes_of(std::string(1, c), height);
    ASSERT_FALSE(strokes.empty()) << c;
    std::vector<double> shape;
    for (const TextStroke& s : strokes)
      for (const Eigen::Vector2d& p : {s.a, s.b}) {
        EXPECT_GE(p.x(), 0) << c;
        EXPECT_LE(p.x(), text_width("x", height)) << c;
        EXPECT_GE(p.y(), -height / 8) << c;
        EXPECT_LE(p.y(), height) << c;
        shape.insert(shape.end(), {p.x(), p.y()});
      }
    EXPECT_TRUE(shapes.insert(shape).second) << c << " looks like another glyph";
  }
  EXPECT_TRUE(strokes_of(" ", height).empty());
}

TEST(StrokeFont, LinesAndCharactersBeyondAscii) {
  EXPECT_DOUBLE_EQ(text_width("abc\nabcde\na", 12), 5 * text_width("a", 12));
  EXPECT_DOUBLE_EQ(text_width("é", 12), text_width("e", 12)) << "two bytes, one character";
  EXPECT_EQ(strokes_of("é", 12).size(), strokes_of("?", 12).size());
  EXPECT_GT(strokes_of("\nx", 12)[0].a.y(), line_spacing(12));
  EXPECT_EQ(strokes_of("\xff\x80\x01", 12).size(), 2 * strokes_of("?", 12).size());
}

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
  for (const double spacing : {0., 0.05, 0.1, 0.15, 0.3, 1.}) {
    const DrawList list = texts_in_a_row(9, spacing, 1);
    const auto placed = place_texts(list, list.cameras[0]);
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
  const DrawList list = texts_in_a_row(5, 0.1, 2);
  const auto left = place_texts(list, list.cameras[0]), right = place_texts(list, list.cameras[1]);
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_EQ(left[i].origin.y(), right[i].origin.y());
    EXPECT_GT(left[i].origin.x(), right[i].origin.x()) << "parallax";
  }
  EXPECT_GT(left[1].lift, 0);
}

TEST(TextLayout, LeavesTheOverlayAndWhatIsBehindTheEyeAlone) {
  DrawList list = texts_in_a_row(2, 0, 1);
  list.texts[0].at.z() = 5;
  list.texts.push_back({.text = "x", .at = {400, 300, 0}});
  const auto placed = place_texts(list, list.cameras[0]);
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_EQ(placed[0].lift, 0);
  EXPECT_EQ(placed[1].origin, Eigen::Vector2d(400, 300));
}

TEST(TextLayout, OnAFinerDisplayEverythingIsAsManyPixelsLarger) {
  DrawList list = texts_in_a_row(3, 0.1, 1);
  list.texts.push_back({.text = "x", .at = {400, 300, 0}});
  const auto usual = place_texts(list, list.cameras[0]);
  list.scale = 2;
  list.cameras[0].width *= 2;
  list.cameras[0].height *= 2;
  const auto fine = place_texts(list, list.cameras[0]);
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

TEST(Text, IsLegibleOnAnyGround) {
  for (const double ground : {0.0, 0.5, 1.0}) {
    DrawList list;
    list.cameras = {straight_camera({0, 0, 1}, 160, 40)};
    list.background = Vec3::Constant(ground);
    list.texts = {{"Prosector", {10, 10, 0}, true, 16, {1, 1, 1}}};
    const Image image = picture_of(list, 160, 40);
    int bright = 0, dark = 0;
    for (int y = 8; y < 30; ++y)
      for (int x = 8; x < 130; ++x) {
        bright += luminance(image.pixel(x, y)) > 200 ? 1 : 0;
        dark += luminance(image.pixel(x, y)) < 60 ? 1 : 0;
      }
    EXPECT_GT(bright, 150) << ground;
    EXPECT_GT(dark, 150) << ground;
  }
}

}  // namespace
}  // namespace prosector
