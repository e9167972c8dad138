#include "client/text/glyph_sheet.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace prosector {
namespace {

/// Draws a glyph of one shade.
GlyphImage image_of(int width, int height, std::uint8_t shade) {
  GlyphImage image{width, height, 0, height, {}};
  image.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), shade);
  return image;
}

TEST(GlyphSheet, KeepsItsBoundAndEveryGlyphUnderFiveThousand) {
  GlyphSheet sheet;
  std::mt19937 random(3);
  std::vector<std::pair<GlyphSpot, std::uint8_t>> since_cleared;
  int cleared = 0;
  for (std::uint32_t k = 0; k < 5000; ++k) {
    const auto shade = static_cast<std::uint8_t>(1 + k % 255);
    const int width = 8 + static_cast<int>(random() % 32), height = 8 + static_cast<int>(random() % 32);
    const auto make = [&] { return image_of(width, height, shade); };
    auto spot = sheet.spot({.glyph = k, .size = 1}, make);
    if (!spot) {
      ++cleared;
      since_cleared.clear();
      sheet.clear();
      spot = sheet.spot({.glyph = k, .size = 1}, make);
      ASSERT_TRUE(spot);
    }
    since_cleared.emplace_back(*spot, shade);
    ASSERT_LE(sheet.height(), GlyphSheet::most_height);
    ASSERT_LE(spot->x + spot->width, GlyphSheet::width);
    ASSERT_LE(spot->y + spot->height, sheet.height());
  }
  EXPECT_GT(cleared, 0) << "so many don't fit at once";
  EXPECT_LT(cleared, 4) << "nearly all of the sheet is used";
  for (const auto& [spot, shade] : since_cleared)
    for (int y = spot.y; y < spot.y + spot.height; ++y)
      for (int x = spot.x; x < spot.x + spot.width; ++x)
        ASSERT_EQ(sheet.row(y)[x], shade) << "another glyph is drawn over it";
}

TEST(GlyphSheet, DrawsAGlyphOnce) {
  GlyphSheet sheet;
  int drawn = 0;
  const auto make = [&] {
    ++drawn;
    return image_of(10, 12, 200);
  };
  const auto first = sheet.spot({.glyph = 1, .size = 64}, make),
             again = sheet.spot({.glyph = 1, .size = 64}, make);
  EXPECT_EQ(drawn, 1);
  EXPECT_EQ(first->x, again->x);
  (void)sheet.spot({.glyph = 1, .size = 65}, make);
  (void)sheet.spot({.glyph = 1, .size = 64, .phase = 1}, make);
  (void)sheet.spot({.font = 1, .glyph = 1, .size = 64}, make);
  EXPECT_EQ(drawn, 4);
}

TEST(GlyphSheet, TellsWhichRowsChanged) {
  GlyphSheet sheet;
  const auto spot = sheet.spot({.glyph = 1}, [] { return image_of(5, 9, 1); });
  const GlyphSheet::Rows rows = sheet.take_changed();
  EXPECT_EQ(rows.first, spot->y);
  EXPECT_EQ(rows.end, spot->y + 9);
  const GlyphSheet::Rows none = sheet.take_changed();
  EXPECT_EQ(none.first, none.end);
  sheet.clear();
  EXPECT_EQ(sheet.take_changed().end, sheet.height());
}

TEST(GlyphSheet, LeavesOutWhatIsEmptyOrTooLarge) {
  GlyphSheet sheet;
  EXPECT_EQ(sheet.spot({.glyph = 1}, [] { return GlyphImage{}; })->width, 0);
  EXPECT_EQ(sheet.spot({.glyph = 2}, [] { return image_of(2000, 10, 1); })->width, 0);
  EXPECT_EQ(sheet.spot({.glyph = 3}, [] { return image_of(10, 600, 1); })->width, 0);
}

}  // namespace
}  // namespace prosector
