// Translations: those that ship, and bytes that are none.

#include "client/language/catalogue.h"

#include <gtest/gtest.h>

#include <random>

#include "common/embedded_file.h"
#include "common/error.h"

namespace prosector {

extern const std::span<const EmbeddedFile> shipped_catalogues;

namespace {

TEST(Catalogue, SpeaksTheLanguageOfATagAndOfItsRegions) {
  EXPECT_STREQ(catalogue_for("de").tr("Participate"), "Teilnehmen");
  EXPECT_STREQ(catalogue_for("de-AT").tr("Participate"), "Teilnehmen");
  EXPECT_STREQ(catalogue_for("DE").tr("Participate"), "Teilnehmen");
  EXPECT_STREQ(catalogue_for("tr").tr("Participate"), "Katıl");
  EXPECT_EQ(catalogue_for("de").tr("{} cut the {}", "Ada", "Leber"), "Ada hat geschnitten: Leber");
}

TEST(Catalogue, IsEnglishForOtherLanguagesAndForUnknownTexts) {
  for (const char* tag : {"", "en", "fr", "x-klingon", "../de", "deu"})
    EXPECT_STREQ(catalogue_for(tag).tr("Participate"), "Participate") << tag;
  EXPECT_STREQ(catalogue_for("de").tr("no such text"), "no such text");
  EXPECT_EQ(catalogue_for("de").tr("no such {}", 1), "no such 1");
  EXPECT_STREQ(catalogue_for("de").tr(""), "") << "not the header of the file";
  EXPECT_EQ(Catalogue().tr("{:.1f} mm", 2.), "2.0 mm");
}

TEST(Catalogue, LeavesATranslationThatValuesDoNotFit) {
  const Catalogue words(Translations{{"{} of {}", "{} von {} und {}"},
                                     {"{:.1f} mm", "{:d} mm"},
                                     {"{} Hz", "{ Hz"},
                                     {"{} and {}", "{1} und {0}"}});
  EXPECT_EQ(words.tr("{} of {}", 1, 2), "1 of 2");
  EXPECT_EQ(words.tr("{:.1f} mm", 2.), "2.0 mm");
  EXPECT_EQ(words.tr("{} Hz", 60), "60 Hz");
  EXPECT_EQ(words.tr("{} and {}", 1, 2), "2 und 1") << "another order";
}

TEST(Catalogue, GivesTextsThatStayWhereTheyAre) {
  const Catalogue words = catalogue_for("de"), copy = words;
  EXPECT_EQ(words.tr("Observe"), copy.tr("Observe")) << "copies share them";
}

/// Returns a .mo file of one text, of the other byte order where it is `swapped`.
std::string small_mo(bool swapped) {
  std::string out;
  for (const std::uint32_t n : {0x950412deu, 0u, 1u, 28u, 36u, 0u, 0u, 2u, 44u, 3u, 47u})
    for (unsigned k = 0; k < 4; ++k) out += static_cast<char>(n >> 8 * (swapped ? 3 - k : k));
  return out + std::string("on\0auf\0", 7);
}

TEST(ReadMo, ReadsBothByteOrders) {
  const Translations expected = {{"on", "auf"}};
  EXPECT_EQ(read_mo(small_mo(false)), expected);
  EXPECT_EQ(read_mo(small_mo(true)), expected);
}

TEST(ReadMo, RefusesWhatEndsTooEarlyOrIsNone) {
  EXPECT_THROW(read_mo(""), InputError);
  EXPECT_THROW(read_mo("GIF89a and so on, and so on"), InputError);
  const std::string whole = small_mo(false);
  for (std::size_t size = 0; size + 1 < whole.size(); ++size)
    EXPECT_THROW(read_mo(std::string_view(whole).substr(0, size)), InputError) << size;
}

TEST(ReadMo, ReadsNothingBesideTheBytesWhateverTheyAre) {
  ASSERT_FALSE(shipped_catalogues.empty());
  const std::string_view whole = shipped_catalogues.front().text;
  std::mt19937 random(20261128);
  int refused = 0;
  for (int round = 0; round < 400; ++round) {
    std::string bytes(whole.substr(0, round % 2 == 0 ? whole.size() : random() % whole.size()));
    for (int k = 0; k < 8 && !bytes.empty(); ++k)
      bytes[random() % std::min<std::size_t>(bytes.size(), round % 3 == 0 ? 28 : bytes.size())] =
          static_cast<char>(random());
    try {
      (void)read_mo(bytes);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace prosector
