// What is laid out by the indices of a surface's vertices and triangles follows a change of these lists.

#include <gtest/gtest.h>

#include <algorithm>

#include "server/physics/mechanics/collision/surface/space_order.h"
#include "tests/random.h"

namespace prosector {
namespace {

std::vector<Vec3> points(Random& random, std::size_t count, double reach) {
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < count; ++i) {
    out.push_back(random.point(reach));
    if (i % 5 == 1) out.back() = out[i - 1];  // in one cell
  }
  return out;
}

/// Each goes with that chance; so many come at random places.
ListEdit random_edit(Random& random, std::size_t before, double chance, std::size_t coming) {
  std::vector<std::uint32_t> gone, come_before;
  for (std::uint32_t i = 0; i < before; ++i)
    if (random.uniform(0, 1) < chance) gone.push_back(i);
  for (std::size_t i = 0; i < coming; ++i)
    come_before.push_back(static_cast<std::uint32_t>(random.below(before + 1)));
  std::sort(come_before.begin(), come_before.end());
  return ListEdit(before, gone, come_before);
}

TEST(ListEdits, KeepTheOrderOfWhatStays) {
  std::vector<int> list = {10, 11, 12, 13, 14};
  const ListEdit edit(list.size(), {0, 3}, std::vector<std::uint32_t>{1, 3, 5, 5});
  EXPECT_EQ(edit.come, (std::vector<std::uint32_t>{0, 3, 5, 6}));
  EXPECT_EQ(edit.now, (std::vector<std::uint32_t>{ListEdit::none, 1, 2, ListEdit::none, 4}));
  EXPECT_FALSE(edit.keeps_indices());
  apply(edit, std::vector<int>{1, 2, 3, 4}, list);
  EXPECT_EQ(list, (std::vector<int>{1, 11, 12, 2, 14, 3, 4}));
  const ListEdit appended(list.size(), {}, std::vector<std::uint32_t>{7});
  EXPECT_TRUE(appended.keeps_indices());
  apply(appended, std::vector<int>{5}, list);
  EXPECT_EQ(list.back(), 5);
  apply(ListEdit(list.size(), {0, 1, 2, 3, 4, 5, 6, 7}, {}), std::vector<int>{}, list);
  EXPECT_TRUE(list.empty());
}

// With points that come within the box of the others, with such that widen it, and with such at its sides
// that go.
TEST(SpaceOrders, FollowToThoseMadeAnew) {
  Random random(20261122);
  std::vector<Vec3> all = points(random, 200, 0.1);
  collision::SpaceOrder followed(all);
  for (int change = 0; change < 60; ++change) {
    const bool much = change % 10 == 9;
    const ListEdit edit = random_edit(random, all.size(), much ? 0.3 : 0.01, much ? 60 : 3);
    const std::vector<Vec3> come = points(random, edit.come.size(), change % 7 == 6 ? 0.12 : 0.09);
    apply(edit, come, all);
    followed.follow(edit, come);
    ASSERT_TRUE(std::ranges::equal(followed.order(), collision::SpaceOrder(all).order()))
        << "change " << change;
  }
}

}  // namespace
}  // namespace prosector
