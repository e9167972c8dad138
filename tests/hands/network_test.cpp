// Networks: what XNNPACK makes of each kind of layer against plain loops, and files that were written, torn
// and changed.
#include <gtest/gtest.h>

#include <cmath>

#include "common/error.h"
#include "drivers/camera/nets/net_file.h"
#include "drivers/camera/nets/network.h"
#include "tests/hands/reference_net.h"
#include "tests/real_data.h"

namespace prosector {
namespace {

std::vector<float> random_input(Random& random, std::size_t count) {
  std::vector<float> out(count);
  for (float& x : out) x = static_cast<float>(random.uniform(0, 1));
  return out;
}

/// Compares a run of XNNPACK with plain loops, on one random input.
void expect_same(const NetPlan& plan, Random& random) {
  Network network(plan);
  for (int again = 0; again < 2; ++again) {
    const std::vector<float> input = random_input(random, network.input().size());
    std::copy(input.begin(), input.end(), network.input().begin());
    network.run();
    const auto wanted = run_slowly(plan, input);
    ASSERT_EQ(wanted.size(), plan.outputs.size());
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      const auto got = network.output(k);
      ASSERT_EQ(got.size(), wanted[k].size());
      float largest = 1;
      for (const float x : wanted[k]) largest = std::max(largest, std::abs(x));
      for (std::size_t n = 0; n < got.size(); ++n)
        ASSERT_NEAR(got[n], wanted[k][n], 1e-4F * largest) << k << ", " << n;
    }
  }
}

TEST(Network, RunsEachKindOfLayerAsPlainLoopsDo) {
  Random random(3);
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    expect_same(random_net(random), random);
  }
}

TEST(Network, RunsTheFetchedNetworksAsPlainLoopsDo) {
  Random random(4);
  for (const char* name : {"palm_lite.tflite", "hand_landmark_lite.tflite", "face_short_range.tflite"}) {
    SCOPED_TRACE(name);
    const std::string file = find_in_data(name);
    if (file.empty()) GTEST_SKIP() << "no " << name << ": deploy/fetch_models.sh";
    expect_same(load_net(file), random);
  }
}

bool same_plan(const NetPlan& a, const NetPlan& b) {
  if (a.input != b.input || a.outputs != b.outputs || a.layers.size() != b.layers.size()) return false;
  for (std::size_t k = 0; k < a.layers.size(); ++k) {
    const NetLayer &x = a.layers[k], &y = b.layers[k];
    if (x.kind != y.kind || x.inputs != y.inputs || x.output != y.output || x.activation != y.activation ||
        x.before != y.before || x.after != y.after || x.window_x != y.window_x || x.stride_y != y.stride_y)
      return false;
  }
  return true;
}

TEST(NetFile, GivesBackWhatWasWritten) {
  Random random(5);
  for (int k = 0; k < 40; ++k) {
    const NetPlan plan = random_net(random);
    for (const bool halves : {false, true}) {
      const NetPlan read = read_net(write_net(plan, halves));
      ASSERT_TRUE(same_plan(plan, read)) << k;
      for (std::size_t t = 0; t < plan.tensors.size(); ++t) {
        ASSERT_EQ(plan.tensors[t].shape, read.tensors[t].shape);
        ASSERT_EQ(plan.tensors[t].values.size(), read.tensors[t].values.size());
        for (std::size_t n = 0; n < plan.tensors[t].values.size(); ++n)
          ASSERT_NEAR(plan.tensors[t].values[n], read.tensors[t].values[n], halves ? 1e-3 : 0);
      }
    }
  }
}

TEST(NetFile, KnowsEveryHalf) {
  for (std::uint32_t half = 0; half < 0x10000; ++half) {
    const int exponent = static_cast<int>((half >> 10) & 31);
    const double rest = half & 1023u, sign = half & 0x8000u ? -1 : 1;
    const double wanted = exponent == 0 ? std::ldexp(rest, -24) : std::ldexp(1024 + rest, exponent - 25);
    const float got = from_half(static_cast<std::uint16_t>(half));
    if (exponent == 31)
      ASSERT_FALSE(std::isfinite(got));
    else
      ASSERT_EQ(got, sign * wanted) << half;
  }
}

/// Tells whether the bytes are read and run, or refused in words; anything else ends the test.
bool is_read(const std::vector<std::uint8_t>& bytes) {
  try {
    Network(read_net(bytes)).run();
    return true;
  } catch (const InputError& error) {
    EXPECT_GT(std::string(error.what()).size(), 8u);
    return false;
  }
}

TEST(NetFile, RefusesEveryTornFile) {
  Random random(6);
  const std::vector<std::uint8_t> whole = write_net(random_net(random), true);
  ASSERT_TRUE(is_read(whole));
  std::size_t read = 0;
  for (std::size_t size = 0; size < whole.size(); size += size < 3000 ? 1 : 37)
    read += is_read({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
  EXPECT_EQ(read, 0u);
}

TEST(NetFile, StandsEveryChangeOfBytes) {
  Random random(7);
  const std::vector<std::uint8_t> whole = write_net(random_net(random), true);
  std::size_t refused = 0;
  for (int k = 0; k < 20000; ++k) {
    std::vector<std::uint8_t> changed = whole;
    for (std::size_t n = 0; n <= random.below(3); ++n)
      changed[random.below(changed.size())] = static_cast<std::uint8_t>(random.below(256));
    refused += !is_read(changed);
  }
  EXPECT_GT(refused, 500u) << "most bytes are weights, but not all";
}

TEST(NetFile, NamesTheFile) {
  try {
    load_net("/dev/null/gone.tflite");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("gone.tflite"), std::string::npos);
  }
}

}  // namespace
}  // namespace prosector
