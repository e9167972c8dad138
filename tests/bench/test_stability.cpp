// Tests that no configuration fails under the fast extremes of prosector-bench stability.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <functional>
#include <string>

#include "tests/bench/stability_run.h"
#include "tests/bench/stability_rungs.h"

namespace prosector {
namespace {

constexpr double limit_ms = 1e6;  // effectively unlimited

#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t every =
    3;  // sanitizers are twenty times as slow: run every third extreme of each configuration
#else
constexpr std::size_t every = 1;
#endif

class Stability : public testing::TestWithParam<StabilityRung> {};
INSTANTIATE_TEST_SUITE_P(Rungs, Stability, testing::ValuesIn(stability_rungs("")), [](const auto& info) {
  std::string name = row_name(info.param);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

TEST_P(Stability, NoVerdictIsFails) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  std::size_t turn = std::hash<std::string>{}(row_name(GetParam())) % every;
  for (const Extreme& extreme : extremes()) {
    if (!extreme.cheap || !extreme.is_for(GetParam().mesh)) continue;
    if (turn++ % every != 0) continue;
    const StabilityResult result = run_extreme(GetParam(), extreme, limit_ms);
    ASSERT_TRUE(result.verdict.has_value()) << extreme.name << ": " << result.reason;
    EXPECT_NE(*result.verdict, Verdict::fails) << extreme.name << ": " << result.reason;
  }
}

}  // namespace
}  // namespace prosector
