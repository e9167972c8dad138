#include "common/hash.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace prosector {
namespace {

ContentHash of(const std::string& text) {
  return content_hash(std::as_bytes(std::span(text.data(), text.size())));
}

TEST(Hash, ContentIsNamedAlikeOnEveryMachine) {
  // XXH3-128 of nothing, from the algorithm's specification.
  EXPECT_EQ(to_hex(of("")), "99aa06d3014798d86001c324468d497f");
  EXPECT_EQ(of("liver"), of("liver"));
}

TEST(Hash, EveryBitCounts) {
  std::string text(300, 'x');
  std::set<ContentHash> seen = {of(text)};
  for (std::size_t at = 0; at < text.size(); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      std::string other = text;
      other[at] = static_cast<char>(other[at] ^ (1 << bit));
      EXPECT_TRUE(seen.insert(of(other)).second);
    }
}

TEST(Hash, HexIsFixedWidth) {
  EXPECT_EQ(to_hex(std::uint64_t{0}), "0000000000000000");
  EXPECT_EQ(to_hex(std::uint64_t{0xabc}), "0000000000000abc");
  EXPECT_EQ(to_hex(ContentHash{}).size(), 32u);
}

TEST(StateHasher, FeedsBitsInOrderHoweverTheyAreSplit) {
  const std::array<double, 4> values = {1, -0.0, 3.5, 1e-300};
  StateHasher whole, parts, swapped, negative_zero;
  whole.add(values.data(), 4);
  for (const double v : values) parts.add(v);
  swapped.add(values.data() + 2, 2);
  swapped.add(values.data(), 2);
  for (const double v : {1.0, 0.0, 3.5, 1e-300}) negative_zero.add(v);
  EXPECT_EQ(whole.digest(), parts.digest());
  EXPECT_NE(whole.digest(), swapped.digest());
  EXPECT_NE(whole.digest(), negative_zero.digest());  // bits, not values
  EXPECT_EQ(whole.digest(), whole.digest());          // reading changes nothing
}

}  // namespace
}  // namespace prosector
