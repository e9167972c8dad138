// States to rewind to: what is kept when memory is short, and how that is told.

#include "server/session/people/moments.h"

#include <gtest/gtest.h>

namespace prosector {
namespace {

TEST(Moments, KeepsTheFirstTheNewestAndEverFewerOfTheOlderOnes) {
  Moments moments(50 * 100);
  for (std::uint32_t n = 0; n < 1000; ++n)
    moments.keep(n, {{3, n}}, std::vector<std::uint8_t>(100, static_cast<std::uint8_t>(n)));
  EXPECT_EQ(moments.bytes(), 50u * 100u);
  EXPECT_TRUE(moments.find(3, 0));
  for (std::uint32_t n = 995; n < 1000; ++n) ASSERT_TRUE(moments.find(3, n)) << n;
  EXPECT_EQ(moments.find(3, 999)->front(), static_cast<std::uint8_t>(999));
  const auto within = [&](std::uint32_t first, std::uint32_t last) {
    int count = 0;
    for (std::uint32_t n = first; n < last; ++n) count += moments.find(3, n) ? 1 : 0;
    return count;
  };
  EXPECT_GT(within(900, 1000), within(500, 600));
  EXPECT_GT(within(1, 500), 2) << "older ones are thinned out, not forgotten";
  EXPECT_FALSE(moments.find(4, 999));
}

TEST(Moments, AStateBeyondAllMemoryIsKeptWhileItIsTheNewest) {
  Moments moments(10);
  for (std::uint32_t n = 0; n < 4; ++n) moments.keep(n, {{0, n}}, std::vector<std::uint8_t>(1000));
  EXPECT_EQ(moments.kept(0), "0 and 3");
}

TEST(Moments, TellsWhatIsKeptInRangesThatAPersonReads) {
  Moments moments;
  EXPECT_EQ(moments.kept(0), "none");
  std::uint32_t tick = 0;
  for (const std::uint32_t n : {0u, 3u, 4u, 5u, 9u}) moments.keep(++tick, {{0, n}, {1, 2 * n}}, {1});
  EXPECT_EQ(moments.kept(0), "0, 3 to 5 and 9");
  EXPECT_EQ(moments.kept(1), "0, 6, 8, 10 and 18");
  for (std::uint32_t n = 100; n < 1000; n += 2) moments.keep(++tick, {{0, n}}, {1});
  EXPECT_LT(moments.kept(0).size(), 120u);
  EXPECT_EQ(moments.kept(0).rfind("0, …, 970, 972", 0), 0u) << moments.kept(0);
}

}  // namespace
}  // namespace prosector
