// Which name a reader is shown.

#include "common/local_name.h"

#include <gtest/gtest.h>

#include "common/ids.h"
#include "common/session_messages.h"
#include "common/valid_text.h"

namespace prosector {
namespace {

TEST(LocalName, TagsFallBackToTheirBeginningsThenToTheName) {
  const std::string name = "liver";
  const std::vector<LocalName> names = {{"de", "Leber"}, {"tr", "karaciğer"}, {"pt-BR", "fígado"}};
  struct {
    const char *tag, *shown;
  } const table[] = {{"de", "Leber"}, {"de-AT", "Leber"},      {"de_AT", "Leber"},
                     {"DE", "Leber"}, {"de-Latn-AT", "Leber"}, {"pt-br", "fígado"},
                     {"pt", "liver"}, {"pt-BR-x", "fígado"},   {"tr", "karaciğer"},
                     {"", "liver"},   {"deu", "liver"},        {"-", "liver"},
                     {"d", "liver"},  {"en", "liver"},         {"tr-TR", "karaciğer"}};
  for (const auto& row : table) EXPECT_EQ(name_in(row.tag, name, names), row.shown) << row.tag;
  EXPECT_EQ(name_in("de", name, {}), name);
}

TEST(LocalName, LocalesSayTheirLanguage) {
  struct {
    const char *locale, *tag;
  } const table[] = {{"de_AT.UTF-8", "de-AT"},
                     {"de", "de"},
                     {"tr_TR@euro", "tr-TR"},
                     {"C", ""},
                     {"C.UTF-8", ""},
                     {"POSIX", ""},
                     {"", ""},
                     {"../../etc", ""}};
  for (const auto& row : table) EXPECT_EQ(language_of_locale(row.locale), row.tag) << row.locale;
}

TEST(LocalName, TagsAreWordsThatHyphensJoin) {
  for (const char* good : {"de", "pt-BR", "zh-Hant-TW", "de-1996", "x"})
    EXPECT_TRUE(is_language_tag(good)) << good;
  for (const char* bad :
       {"", "-", "de-", "-de", "de--AT", "de_AT", "1a", "d e", "ü", "abcdefghi", "de-abcdefghi"})
    EXPECT_FALSE(is_language_tag(bad)) << bad;
  std::string longest = "abc";
  while (longest.size() + 4 <= max_language_length) longest += "-abc";
  EXPECT_TRUE(is_language_tag(longest));
  EXPECT_FALSE(is_language_tag(longest + "-abc"));
}

TEST(ValidText, NamesAreShortAndWhole) {
  EXPECT_TRUE(valid_name("Größte Drüse"));
  EXPECT_TRUE(valid_name(std::string(max_name_length, 'x')));
  for (const std::string& bad : {std::string(), std::string(max_name_length + 1, 'x'), std::string("a\nb"),
                                 std::string("\xc3"), std::string("\xc0\x80"), std::string("\xed\xa0\x80")})
    EXPECT_FALSE(valid_name(bad));
}

}  // namespace
}  // namespace prosector
