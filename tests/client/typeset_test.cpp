// Text as it is set: widths, lines, directions, fonts.

#include "client/text/typesetter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "client/text/paragraph.h"
#include "client/text/utf8.h"
#include "common/error.h"
#include "tests/client/many_scripts.h"

namespace prosector {
namespace {

using test::many_scripts;
using test::Words;

const std::filesystem::path dejavu = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

double width_of(Typesetter& typesetter, std::string_view text) {
  return typesetter.set(text, {}).width();
}

/// Returns what the lines hold, one after the other, without blanks.
std::string letters_of(const TextBlock& block) {
  std::string out;
  for (const TextLine& line : block.lines) out += line.text;
  std::erase(out, ' ');
  return out;
}

std::string without_blanks(std::string_view text) {
  std::string out(text);
  std::erase(out, ' ');
  return out;
}

TEST(Utf8, RoundTripsWhateverIsWellFormed) {
  for (const Words& words : many_scripts)
    EXPECT_EQ(utf8_of(characters_of(words.description)), words.description) << words.script;
  std::u32string all;
  for (char32_t c = 0xA0; c <= 0x10FFFF; c += 37)
    if (c < 0xD800 || c > 0xDFFF) all += c;
  EXPECT_EQ(characters_of(utf8_of(all)), all);
}

TEST(Utf8, IllFormedPartsBecomeReplacements) {
  const std::u32string one = U"\uFFFD";
  EXPECT_EQ(characters_of("\xff"), one);
  EXPECT_EQ(characters_of("a\x80z"), U"a\uFFFDz");
  EXPECT_EQ(characters_of("\xe2\x82"), one) << "a euro sign that ends early is one";
  EXPECT_EQ(characters_of("\xe2\x82z"), U"\uFFFDz") << "what ends it is kept";
  EXPECT_EQ(characters_of("\xc0\xaf"), one + one) << "overlong";
  EXPECT_EQ(characters_of("\xed\xa0\x80"), one + one + one) << "a surrogate";
  EXPECT_EQ(characters_of("\xf4\x90\x80\x80"), one + one + one + one) << "beyond U+10FFFF";
  EXPECT_EQ(characters_of("a\r\nb\x01\t"), U"a\nb\uFFFD\t") << "controls";
}

TEST(Typesetter, AnyBytesAreSet) {
  Typesetter typesetter;
  std::mt19937 random(7);
  for (int k = 0; k < 300; ++k) {
    std::string bytes(random() % 60, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    const SetText set = typesetter.set(bytes, {.size = 10, .least_size = 5, .width = 50, .height = 40});
    EXPECT_TRUE(std::isfinite(set.width()));
    EXPECT_LE(set.height(), 40 + 1e-9);
  }
  EXPECT_EQ(typesetter.set("", {}).width(), 0);
}

TEST(Typesetter, WidthsAddUp) {
  Typesetter typesetter;
  for (const Words& words : many_scripts) {
    const SetText set = typesetter.set(words.description, {});
    ASSERT_EQ(set.block->lines.size(), 1u) << words.script;
    const TextLine& line = set.block->lines[0];
    double sum = 0;
    for (const PlacedGlyph& glyph : line.glyphs) sum += glyph.advance;
    EXPECT_NEAR(sum, line.width, 1e-9) << words.script;
    EXPECT_NEAR(typesetter.set(words.description, {.size = 3}).width(), 3 * set.width(), 1e-9);
  }
  EXPECT_NEAR(width_of(typesetter, "bile duct"),
              width_of(typesetter, "bile") + width_of(typesetter, " ") + width_of(typesetter, "duct"), 1e-9);
  EXPECT_NEAR(width_of(typesetter, "abc\nabcde\na"), width_of(typesetter, "abcde"), 1e-9);
  EXPECT_NEAR(width_of(typesetter, "e\u0301"), width_of(typesetter, "é"), 0.02) << "a mark takes no room";
}

TEST(Typesetter, WrappingKeepsEveryWordAndTheWidth) {
  Typesetter typesetter;
  for (const Words& words : many_scripts)
    for (const double width : {3.0, 7.0, 12.0, 30.0}) {
      const SetText set = typesetter.set(words.description, {.width = width});
      EXPECT_EQ(letters_of(*set.block), without_blanks(words.description)) << words.script << width;
      for (const TextLine& line : set.block->lines) {
        EXPECT_LE(line.width, width + 1e-6) << words.script << ": " << line.text;
        EXPECT_GE(line.left, -1e-9);
        EXPECT_LE(line.left + line.width, set.width() + 1e-6);
        EXPECT_FALSE(line.text.starts_with(' ') || line.text.ends_with(' ')) << line.text;
      }
    }
}

TEST(Typesetter, BreaksWordsOnlyWhereTheyAreWiderThanTheLine) {
  Typesetter typesetter;
  const std::string text = "the quick brown fox jumps over the lazy dog";
  const SetText set = typesetter.set(text, {.width = 6});
  std::string joined;
  for (const TextLine& line : set.block->lines) joined += (joined.empty() ? "" : " ") + line.text;
  EXPECT_EQ(joined, text);
  const SetText word = typesetter.set(std::string(40, 'm'), {.width = 5});
  EXPECT_GT(word.block->lines.size(), 5u);
  EXPECT_GT(word.block->lines[0].width, 4) << "lines are filled";
  const SetText narrow = typesetter.set("mmm", {.width = 0.01});
  EXPECT_EQ(narrow.block->lines.size(), 3u) << "each line has a letter";
}

TEST(Typesetter, ShrinksThenCutsWhatIsTooLong) {
  Typesetter typesetter;
  const TextFrame frame{.size = 10, .least_size = 6, .width = 100, .height = 30};
  const SetText small = typesetter.set("short", frame);
  EXPECT_EQ(small.size, 10);
  const SetText shrunk = typesetter.set("words that need some more room than that", frame);
  EXPECT_LT(shrunk.size, 10);
  EXPECT_FALSE(shrunk.block->cut);
  for (const Words& words : many_scripts) {
    std::string text;
    for (int k = 0; k < 20; ++k) text += std::string(words.description) + " ";
    const SetText cut = typesetter.set(text, frame);
    EXPECT_EQ(cut.size, 6) << words.script;
    EXPECT_TRUE(cut.block->cut) << words.script;
    EXPECT_LE(cut.height(), 30 + 1e-9) << words.script;
    EXPECT_LE(cut.width(), 100 + 1e-6) << words.script;
    const std::string& last = cut.block->lines.back().text;
    EXPECT_TRUE(last.ends_with("…")) << last;
    EXPECT_GT(cut.block->lines.back().width, 6) << words.script << ": as much as there is room for: " << last;
  }
}

TEST(Typesetter, ColumnsBeginAtOnePlace) {
  Typesetter typesetter;
  const SetText set = typesetter.set("depth\t2 mm\nimpulse\t0.1 N s\nno column\nx\ty", {});
  const auto begin = [&](std::size_t line, std::uint32_t character, std::size_t skip) {
    const auto& glyphs = set.block->lines[line].glyphs;
    for (std::size_t k = skip; k < glyphs.size(); ++k)
      if (glyphs[k].character == character) return glyphs[k].x;
    return -1.0;
  };
  EXPECT_GT(begin(0, 0, 5), width_of(typesetter, "impulse"));
  EXPECT_NEAR(begin(0, 0, 5), begin(1, 0, 7), 1e-9);
  EXPECT_NEAR(begin(0, 0, 5), begin(3, 0, 1), 1e-9);
  EXPECT_EQ(set.block->lines[1].text, "impulse\t0.1 N s");
  const SetText narrow = typesetter.set("key\twords that are broken within their column", {.width = 12});
  ASSERT_GT(narrow.block->lines.size(), 1u);
  EXPECT_GT(narrow.block->lines[1].glyphs[0].x, 1);
  EXPECT_LE(narrow.width(), 12 + 1e-9);
}

/// Returns the characters of a line from left to right, by their places in the text.
std::vector<std::uint32_t> order_of(Fonts& fonts, const std::u32string& text) {
  std::vector<std::uint32_t> out;
  for (const PlacedGlyph& glyph : Paragraph(fonts, text).line(0, text.size()).glyphs)
    out.push_back(glyph.character);
  return out;
}

TEST(Paragraph, MixedDirectionsStandInTheirOrder) {
  Fonts fonts{FontCatalogue()};
  using Order = std::vector<std::uint32_t>;
  EXPECT_EQ(order_of(fonts, U"ab"), (Order{0, 1}));
  EXPECT_EQ(order_of(fonts, U"אבג"), (Order{2, 1, 0}));
  EXPECT_EQ(order_of(fonts, U"ab אב 12"), (Order{0, 1, 2, 6, 7, 5, 4, 3}))
      << "numbers belong to what is before";
  EXPECT_EQ(order_of(fonts, U"אב ab"), (Order{3, 4, 2, 1, 0})) << "the first letter says which way";
  EXPECT_EQ(order_of(fonts, U"א (ב)"), (Order{4, 3, 2, 1, 0}));
}

TEST(Paragraph, LettersJoinInArabicAndMarksFollowTheirLetters) {
  Fonts fonts{FontCatalogue()};
  const std::u32string three = U"ببب";
  const TextLine joined = Paragraph(fonts, three).line(0, 3);
  ASSERT_EQ(joined.glyphs.size(), 3u);
  EXPECT_NE(joined.glyphs[0].glyph, joined.glyphs[1].glyph) << "final and medial";
  EXPECT_NE(joined.glyphs[1].glyph, joined.glyphs[2].glyph) << "medial and initial";
  const std::vector<double> advances = Paragraph(fonts, U"कि").advances();
  EXPECT_GT(advances[0], 0);
  EXPECT_LT(advances[1], 0) << "no line is broken before a vowel sign";
}

TEST(Typesetter, LinesFromTheRightAreFlushRight) {
  Typesetter typesetter;
  const SetText set = typesetter.set("abc\nאב", {.width = 20});
  EXPECT_EQ(set.block->lines[0].left, 0);
  EXPECT_NEAR(set.block->lines[1].left + set.block->lines[1].width, 20, 1e-9);
}

TEST(Typesetter, CentredLinesHaveOneMiddle) {
  Typesetter typesetter;
  const SetText set = typesetter.set("a\nlonger", {.centred = true});
  for (const TextLine& line : set.block->lines)
    EXPECT_NEAR(line.left + line.width / 2, set.width() / 2, 1e-9);
}

// All that the recommended packages are for (deploy/packages.txt).
TEST(Fonts, FallBackOnOneThatHasTheCharacter) {
  Fonts fonts{FontCatalogue()};
  EXPECT_EQ(fonts.catalogue().file(0).family, "DejaVu Sans");
  for (const Words& words : many_scripts)
    for (const char32_t c : characters_of(words.description))
      EXPECT_TRUE(fonts.has(fonts.font_of(c), c)) << words.script << ": " << utf8_of(std::u32string(1, c));
  EXPECT_EQ(fonts.font_of(U'ğ'), 0u);
  EXPECT_NE(fonts.font_of(U'肝'), 0u);
  for (const Words& words : many_scripts) {
    Typesetter typesetter;
    for (const TextLine& line : typesetter.set(words.description, {}).block->lines)
      for (const PlacedGlyph& glyph : line.glyphs) EXPECT_NE(glyph.glyph, 0u) << words.script << ": a box";
  }
}

TEST(Fonts, WhatNoFontHasIsABox) {
  Typesetter typesetter(FontCatalogue({dejavu}));
  const SetText set = typesetter.set("a肝b", {});
  ASSERT_EQ(set.block->lines[0].glyphs.size(), 3u);
  const PlacedGlyph& box = set.block->lines[0].glyphs[1];
  EXPECT_EQ(box.glyph, 0u);
  EXPECT_GT(typesetter.font(box.font).coverage(0, 20 * 64, 0).width, 4) << "a box is to be seen";
}

TEST(Fonts, WithoutAnyTheErrorSaysWhatToInstall) {
  EXPECT_THROW(FontCatalogue(std::vector<std::filesystem::path>{}), InputError);
  EXPECT_THROW(FontCatalogue({"/dev/null"}), InputError);
}

TEST(Font, CoverageMovesWithItsPhaseAndGrowsWithItsSize) {
  Fonts fonts{FontCatalogue()};
  const Font& font = fonts.at(0);
  const std::uint32_t glyph = Paragraph(fonts, U"H").line(0, 1).glyphs[0].glyph;
  const auto ink = [](const GlyphImage& image) {
    return std::accumulate(image.pixels.begin(), image.pixels.end(), 0.0) / 255;
  };
  const GlyphImage small = font.coverage(glyph, 20 * 64, 0), large = font.coverage(glyph, 40 * 64, 0);
  EXPECT_NEAR(ink(large) / ink(small), 4, 0.4);
  EXPECT_NEAR(ink(font.coverage(glyph, 20 * 64, 2)), ink(small), 1);
  EXPECT_NE(font.coverage(glyph, 20 * 64, 2).pixels, small.pixels);
  EXPECT_EQ(font.coverage(glyph, 20 * 64, 0).pixels, small.pixels);
}

TEST(Font, DistancesAreThoseToTheOutline) {
  Fonts fonts{FontCatalogue()};
  const std::uint32_t glyph = Paragraph(fonts, U"I").line(0, 1).glyphs[0].glyph;
  const GlyphImage image = fonts.at(0).distances(glyph);
  ASSERT_GT(image.width, 2 * distance_reach);
  // Across the middle of a stem distances rise and fall by one a pixel.
  const std::uint8_t* row = image.pixels.data() + image.height / 2 * image.width;
  const double step = 127.0 / distance_reach;
  for (int x = 2; x < distance_reach; ++x) EXPECT_NEAR(row[x] - row[x - 1], step, 3) << x;
  const int middle = *std::max_element(row, row + image.width);
  EXPECT_GT(middle, 128 + step);
}

}  // namespace
}  // namespace prosector
