// The map of a body's error that travels.

#include "common/error_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace prosector {
namespace {

TEST(ErrorMap, LevelsAreWithinAFewPerCentOfTheError) {
  for (double error = min_mapped_error; error < 9; error *= 1.01)
    EXPECT_NEAR(error_of(level_of(error)) / error, 1, 0.024) << error;
  EXPECT_EQ(level_of(0), 0);
  EXPECT_EQ(level_of(std::nan("")), 0);
  EXPECT_EQ(level_of(1e9), 255);
  for (int level = 0; level < 256; ++level)
    EXPECT_EQ(level_of(error_of(static_cast<std::uint8_t>(level))), level);
}

TEST(ErrorMap, GoesEvenlyFromOneValueToTheNext) {
  ErrorMap map;
  map.corner = {1, 0, -1};
  map.cell = 0.5;
  map.size = {2, 1, 3};
  map.levels = {10, 60, 20, 70, 30, 80};
  EXPECT_EQ(error_at(map, {1, 0, -1}), error_of(10));
  EXPECT_EQ(error_at(map, {1.5, 0, -1}), error_of(60));
  EXPECT_EQ(error_at(map, {1, 7, 0}), error_of(30)) << "one layer, whatever its height";
  EXPECT_NEAR(*error_at(map, {1.25, 0, -0.5}), (error_of(20) + error_of(70)) / 2, 1e-15);
  EXPECT_NEAR(*error_at(map, {1, 0, -0.75}), (error_of(10) + error_of(20)) / 2, 1e-15);
  EXPECT_EQ(error_at(map, {9, 0, 9}), error_of(80)) << "beyond it";
  EXPECT_FALSE(error_at({}, {0, 0, 0}));
}

}  // namespace
}  // namespace prosector
