// Trees against looking at everything.

#include <gtest/gtest.h>

#include <map>

#include "common/error.h"
#include "server/physics/mechanics/collision/broad/broad_phase.h"
#include "tests/collision/shapes.h"

namespace prosector {
namespace {

using namespace test;

collision::Aabb random_box(Random& random) {
  const Vec3 at = random_point(random, 5);
  return collision::Aabb{at, at}.grown(between(random, 0.01, 0.6));
}

struct Known {
  collision::Aabb box;
  collision::CollisionMask mask;
  bool moves;
};
using All = std::map<std::uint32_t, Known>;

std::vector<collision::BroadPhase::Pair> brute_force(const All& all) {
  std::vector<collision::BroadPhase::Pair> out;
  for (auto a = all.begin(); a != all.end(); ++a)
    for (auto b = std::next(a); b != all.end(); ++b)
      if ((a->second.moves || b->second.moves) && collision::may_touch(a->second.mask, b->second.mask) &&
          a->second.box.overlaps(b->second.box))
        out.emplace_back(a->first, b->first);
  return out;
}

TEST(BroadPhase, AgreesWithBruteForceWhateverHappens) {
  Random random(1);
  collision::BroadPhase broad(0.05);
  All all;
  const auto any = [&] {
    return std::next(all.begin(),
                     std::uniform_int_distribution<long>(0, static_cast<long>(all.size()) - 1)(random));
  };
  for (int step = 0; step < 6000; ++step) {
    const int what = std::uniform_int_distribution<int>(0, 9)(random);
    if (all.size() < 20 || (what == 0 && all.size() < 150)) {
      std::uint32_t id = 0;
      while (all.contains(id)) ++id;
      const collision::CollisionMask mask =
          step % 3 ? collision::CollisionMask{} : collision::CollisionMask{2, 1};
      const Known known{random_box(random), mask, step % 2 == 0};
      all[id] = known;
      broad.add(id, known.box, known.mask, known.moves);
    } else if (what == 1) {
      const auto gone = any();
      broad.remove(gone->first);
      all.erase(gone);
    } else if (what == 2) {
      const auto changed = any();
      changed->second.moves = !changed->second.moves;
      broad.set_moves(changed->first, changed->second.moves);
    } else {
      const auto changed = any();
      const double far = what < 6 ? 0.03 : 2;
      const Vec3 way = random_point(random, far);
      changed->second.box = what == 9
                                ? random_box(random)
                                : collision::Aabb{changed->second.box.lo + way, changed->second.box.hi + way};
      broad.update(changed->first, changed->second.box);
    }
    if (step % 20) continue;
    ASSERT_EQ(broad.find_pairs(), brute_force(all)) << step;
    const collision::Aabb where = random_box(random);
    std::vector<std::uint32_t> expected;
    for (const auto& [id, known] : all)
      if (known.box.overlaps(where)) expected.push_back(id);
    ASSERT_EQ(broad.query(where), expected);
    ASSERT_EQ(broad.still() + broad.moving(), all.size());
  }
}

TEST(DynamicTree, StaysLow) {
  Random random(2);
  collision::DynamicTree tree(0.01);
  std::vector<collision::DynamicTree::Leaf> leaves;
  // In order along a line: the worst case of a tree that doesn't mend itself.
  for (std::uint32_t i = 0; i < 4096; ++i)
    leaves.push_back(tree.insert(collision::Aabb{Vec3(i, 0, 0), Vec3(i + 0.5, 1, 1)}, i));
  EXPECT_LT(tree.height(), 40);
  for (std::uint32_t i = 0; i < 4096; i += 2) tree.remove(leaves[i]);
  EXPECT_EQ(tree.size(), 2048u);
  std::vector<std::uint32_t> found;
  tree.query({Vec3(-1, 0, 0), Vec3(5000, 1, 1)}, [&](std::uint32_t user) { found.push_back(user); });
  EXPECT_EQ(found.size(), 2048u);
}

TEST(DynamicTree, StaysWhileItFits) {
  collision::DynamicTree tree(0.1);
  const auto leaf = tree.insert({Vec3::Zero(), Vec3::Ones()}, 0);
  EXPECT_FALSE(tree.move(leaf, {Vec3::Constant(0.05), Vec3::Constant(1.05)}));
  EXPECT_TRUE(tree.move(leaf, {Vec3::Constant(0.2), Vec3::Constant(1.2)}));
  EXPECT_TRUE(tree.move(leaf, {Vec3::Constant(0.6), Vec3::Constant(0.61)})) << "it became small";
}

TEST(Masks, BothMustBeWilling) {
  collision::CollisionGroups groups;
  groups.add("organs");
  groups.add("tools");
  const std::vector<std::string> organs{"organs"};
  const collision::CollisionMask organ = groups.mask("organs", {}), tool = groups.mask("tools", organs);
  EXPECT_TRUE(collision::may_touch(organ, tool));
  EXPECT_FALSE(collision::may_touch(tool, tool));
  EXPECT_FALSE(collision::may_touch(tool, collision::CollisionMask{}));
  EXPECT_TRUE(collision::may_touch(organ, collision::CollisionMask{}));
}

TEST(Masks, SayWhatIsWrong) {
  collision::CollisionGroups groups;
  groups.add("organs");
  EXPECT_THROW(groups.add("organs"), InputError);
  EXPECT_THROW(groups.add(""), InputError);
  try {
    groups.mask("organ", {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("default, organs"), std::string::npos) << error.what();
  }
  for (int i = 2; i < 32; ++i) groups.add("group " + std::to_string(i));
  EXPECT_THROW(groups.add("one too many"), InputError);
}

}  // namespace
}  // namespace prosector
