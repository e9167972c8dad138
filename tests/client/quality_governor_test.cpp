// The level of quality that pictures are drawn at follows from their times.

#include "client/render/quality_governor.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>

#include "common/error.h"

namespace prosector {
namespace {

std::string level_after(QualityGovernor& governor, int pictures, const std::function<double()>& cost) {
  for (int k = 0; k < pictures; ++k) governor.took(cost());
  return std::string(governor.level().name);
}

TEST(QualityGovernor, KeepsPicturesWithinTheirTimeAndDoesNotSwing) {
  QualityGovernor slow(0.050);
  EXPECT_EQ(level_after(slow, 20, [] { return 0.090; }), "low");
  EXPECT_EQ(level_after(slow, 500, [] { return 0.090; }), "low") << "there is nothing below";

  QualityGovernor fast(0.050);
  EXPECT_EQ(level_after(fast, 200, [] { return 0.010; }), "high");

  // Each level costs three times the one before; medium fits, high does not.
  QualityGovernor between(0.050);
  int changes = 0;
  std::map<std::string_view, int> drawn;
  for (int k = 0; k < 3000; ++k) {
    const std::string_view name = between.level().name;
    ++drawn[name];
    changes += between.took(name == "low" ? 0.007 : name == "medium" ? 0.021 : 0.063) ? 1 : 0;
  }
  EXPECT_GT(drawn["medium"], 2700);
  EXPECT_LT(changes, 9);
  EXPECT_THROW(QualityGovernor(0), InputError);
}

}  // namespace
}  // namespace prosector
