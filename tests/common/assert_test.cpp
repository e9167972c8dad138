// Assertions throw where they are on, and evaluate nothing where they are off.

#include "common/assert.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/asset.h"
#include "common/error.h"
#include "common/surface_patch.h"

namespace prosector {
namespace {

#ifdef PROSECTOR_ASSERTIONS
constexpr bool on = true;
#else
constexpr bool on = false;
#endif

/// What an assertion says of `holds`; counts how often the condition was evaluated.
std::string said(bool holds, int& evaluated) try {
  PROSECTOR_ASSERT((++evaluated, holds));
  return "";
} catch (const InternalError& error) {
  return error.what();
}

TEST(Assert, ThrowsAnInternalErrorThatNamesThePlaceOnlyWhereAssertionsAreOn) {
  int evaluated = 0;
  const std::string broken = said(false, evaluated);
  EXPECT_EQ(broken.find("assert_test.cpp:") != std::string::npos, on) << broken;
  EXPECT_EQ(broken.find("holds") != std::string::npos, on) << broken;
  EXPECT_EQ(said(true, evaluated), "");
  EXPECT_EQ(evaluated, on ? 2 : 0);
}

TEST(Assert, CanBePartOfAConstantExpression) {
  constexpr int twice = [] {
    PROSECTOR_ASSERT(1 + 1 == 2);
    return 2;
  }();
  EXPECT_EQ(twice, 2);
}

TEST(Assert, ASurfaceWithoutARowForEachVertexIsAFaultOfTheProgram) {
  if (!on) GTEST_SKIP() << "assertions are off in this build";
  DrawnSurface surface;
  surface.rest.positions.resize(1);
  EXPECT_THROW(static_cast<void>(hash(surface)), InternalError);
  EXPECT_THROW(static_cast<void>(difference(surface, surface)), InternalError);
}

TEST(Assert, IsAscendingAllowsNoEquals) {
  EXPECT_TRUE(is_ascending(std::vector<int>{}));
  EXPECT_TRUE(is_ascending(std::vector<int>{1, 2, 5}));
  EXPECT_FALSE(is_ascending(std::vector<int>{1, 2, 2}));
  EXPECT_FALSE(is_ascending(std::vector<int>{2, 1}));
}

}  // namespace
}  // namespace prosector
