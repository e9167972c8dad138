// Scene files that nest too deep are refused before the parser, which recurses, sees them.

#include <gtest/gtest.h>

#include "common/error.h"
#include "common/toml_nesting.h"
#include "tests/scene/scene_texts.h"

namespace prosector {
namespace {

/// `begin`, then `level` again and again, then `end`.
std::string nested(std::string begin, const std::string& level, std::size_t times,
                   const std::string& end = "") {
  for (std::size_t i = 0; i < times; ++i) begin += level;
  return begin.append(end);
}

constexpr std::size_t deep = 300'000;  // past 100,000 the parser overflows an 8 MB stack

TEST(SceneNesting, KeysOfManyPartsAreRefused) {
  for (const std::string& text :
       {nested("name = 's'\n", "a.", deep, "a = 1\n"), nested("name = 's'\n[", "a.", deep, "a]\n"),
        nested("name = 's'\n[[", "\"a\" . ", deep, "a]]\n")})
    EXPECT_EQ(complaint(text), "test.toml:2: a dotted key has too many parts; allowed: at most 32");
}

TEST(SceneNesting, DeepListsAndTablesAreRefused) {
  for (const char* level : {"[", "{a = ", "[{a.b = "})
    EXPECT_EQ(complaint(nested("name = 's'\n\nx = ", level, deep)),
              "test.toml:3: lists and tables are nested too deeply; allowed: at most 32");
}

TEST(SceneNesting, StringsAndCommentsMayHoldAnything) {
  for (const std::string& text :
       {nested("# ", "[a.", 100, "\n"), nested("a = \"\\\"", "[a.", 100, "\"\n"),
        nested("a = '", "[a.", 100, "\\'\n"), nested("a = \"\"\"\n", "[a.\"\n", 100, "\"\"\"\n"),
        nested("a = '''", "[a.", 100, "''\n'''\n")})
    EXPECT_NO_THROW(check_nesting(text, "f")) << text;
}

TEST(SceneNesting, TablesWithoutNamesAreRefused) {
  for (const std::string text : {"[=]", "[[ =", "[\n", "  [[[a]]]", "[\x80", "a = 1\r\n[,"})
    EXPECT_THROW(check_nesting(text, "f"), InputError) << text;
  for (const std::string text : {"[ a ]", "[[ 'x' ]]", "[\"a.b\".c]", "a = [\n[=], 2]", "[-]", "["})
    EXPECT_NO_THROW(check_nesting(text, "f")) << text;
}

TEST(SceneNesting, LettersBeyondAsciiStandInQuotes) {
  for (const std::string text : {"é = 1", "a = é", "a = 1 \xC2\xA1", "[\"é\"]é", "\xFF"})
    EXPECT_THROW(check_nesting(text, "f"), InputError) << text;
  for (const std::string text : {"\xEF\xBB\xBF"
                                 "a = 1",
                                 "a = 'é' # ü", "\"é\" = \"\"\"\nü\"\"\""})
    EXPECT_NO_THROW(check_nesting(text, "f")) << text;
}

// Depth begins anew with each number of a list, and with each key.
TEST(SceneNesting, LongFilesAreNotDeepOnes) {
  EXPECT_NO_THROW(check_nesting(nested("a = [", "[1.5, 2.5], ", 1000, "]\n"), "f"));
  EXPECT_NO_THROW(check_nesting(nested("", "b.c = 1.5\n", 1000), "f"));
}

// A quote left open hides its own line at most.
TEST(SceneNesting, AnOpenQuoteHidesNoBrackets) {
  EXPECT_THROW(check_nesting(nested("a = \"open\nb = ", "[", 100), "f"), InputError);
}

}  // namespace
}  // namespace prosector
