// Surfaces in slots, and the patches between them.

#include "common/surface_patch.h"

#include <gtest/gtest.h>

#include "common/error.h"
#include "tests/common/asset_samples.h"

namespace prosector {
namespace {

using namespace testing_assets;

DrawnSurface random_drawn(std::mt19937_64& random) {
  return rounded(random_mesh(random, 30, 50), random_surface(random, 30, 20));
}

/// What a cut may do to slots: new ones of each kind, others set anew, triangles that die.
DrawnSurface edited(DrawnSurface s, std::mt19937_64& random) {
  const auto index = [&](std::size_t count) { return static_cast<std::uint32_t>(random() % count); };
  const DrawnSurface more = random_drawn(random);
  for (auto n = random() % 4; n > 0; --n) s.streamed.rest.push_back(more.streamed.rest[n]);
  for (auto n = random() % 6; n > 0; --n) {
    s.rest.positions.push_back(more.rest.positions[n]);
    s.streamed.map.rows.push_back(more.streamed.map.rows[n]);
  }
  for (auto n = random() % 6; n > 0; --n) {
    s.streamed.map.rows[index(s.streamed.map.rows.size())].node[0] = index(s.streamed.rest.size());
    s.rest.positions[index(s.rest.positions.size())] = more.rest.positions[n];
  }
  for (auto n = random() % 8; n > 0; --n) s.rest.triangles.push_back({0, index(s.rest.positions.size()), 1});
  for (auto n = random() % 8; n > 0; --n) s.rest.triangles[index(s.rest.triangles.size())] = {0, 0, 0};
  if (random() % 2 == 0) {
    s.rest.inner.resize(s.rest.triangles.size(), 0);
    s.rest.inner[index(s.rest.inner.size())] ^= 1;
  } else if (!s.rest.inner.empty()) {
    s.rest.inner.resize(s.rest.triangles.size(), 0);
  }
  return s;
}

TEST(SurfacePatch, RoundedNumbersAreFloatsToTheLast) {
  std::mt19937_64 random(10);
  for (const std::uint32_t n : {1u, 2u, 3u, 29u, 30u, 31u, 1000u}) {
    const DrawnSurface s = rounded(random_mesh(random, n, 0), random_surface(random, n, n));
    const auto is_float = [](double x) {
      volatile float f = static_cast<float>(x);
      return static_cast<double>(f) == x;
    };
    for (std::size_t i = 0; i < n; ++i)
      for (int k = 0; k < 3; ++k) {
        EXPECT_TRUE(is_float(s.rest.positions[i][k])) << i << " of " << n;
        EXPECT_TRUE(is_float(s.streamed.rest[i][k])) << i << " of " << n;
        EXPECT_TRUE(is_float(s.streamed.map.rows[i].weight[static_cast<std::size_t>(k)]));
      }
  }
}

TEST(SurfacePatch, TheDifferenceAppliedGivesTheOtherWhateverWasEdited) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 300; ++round) {
    DrawnSurface here = random_drawn(random);
    for (int edit = 0; edit < 5; ++edit) {
      const DrawnSurface there = edited(here, random);
      const SurfacePatch patch = difference(here, there);
      apply(patch, here);
      ASSERT_EQ(hash(here), hash(there)) << "round " << round;
      ASSERT_EQ(here.rest.triangles, there.rest.triangles);
      for (std::size_t v = 0; v < here.rest.positions.size(); ++v)
        ASSERT_EQ(here.rest.positions[v], there.rest.positions[v])
            << "round " << round << " edit " << edit << " vertex " << v;
      ASSERT_EQ(here.streamed.rest, there.streamed.rest);
      const SurfacePatch none = difference(here, there);
      EXPECT_TRUE(none.points.empty() && none.vertices.empty() && none.triangles.empty());
    }
  }
}

TEST(SurfacePatch, ThePatchIsNoLargerThanWhatChanged) {
  std::mt19937_64 random(12);
  const DrawnSurface before = random_drawn(random);
  DrawnSurface after = before;
  after.rest.triangles[3] = {7, 7, 7};
  after.rest.positions[4].x() += 1;
  const SurfacePatch patch = difference(before, after);
  ASSERT_EQ(patch.triangles.size(), 1u);
  EXPECT_EQ(patch.triangles[0].slot, 3u);
  ASSERT_EQ(patch.vertices.size(), 1u);
  EXPECT_EQ(patch.vertices[0].slot, 4u);
  EXPECT_TRUE(patch.points.empty());
}

TEST(SurfacePatch, TheHashCoversEveryNumber) {
  std::mt19937_64 random(13);
  const DrawnSurface s = random_drawn(random);
  const auto differs = [&](auto&& change) {
    DrawnSurface other = s;
    change(other);
    return hash(other) != hash(s);
  };
  EXPECT_TRUE(differs([](DrawnSurface& o) { o.streamed.rest[5].z() += 1e-3; }));
  EXPECT_TRUE(differs([](DrawnSurface& o) { o.rest.positions[5].z() += 1e-3; }));
  EXPECT_TRUE(differs([](DrawnSurface& o) { o.streamed.map.rows[5].weight[2] += 1e-3; }));
  EXPECT_TRUE(differs([](DrawnSurface& o) { o.streamed.map.rows[5].node[3] ^= 1; }));
  EXPECT_TRUE(differs([](DrawnSurface& o) { std::swap(o.rest.triangles[5][0], o.rest.triangles[5][1]); }));
  EXPECT_TRUE(differs([](DrawnSurface& o) { o.rest.inner.assign(50, 1); }));
  EXPECT_FALSE(differs([](DrawnSurface& o) { o.rest.inner.assign(50, 0); }));  // none is inner, either way
}

TEST(SurfacePatch, WhatDoesNotFitIsRefusedAndChangesNothing) {
  std::mt19937_64 random(14);
  DrawnSurface s = random_drawn(random);
  const std::uint64_t before = hash(s);
  const auto refused = [&](auto&& spoil) {
    SurfacePatch patch = difference(s, edited(s, random));
    spoil(patch);
    EXPECT_THROW(apply(patch, s), InputError);
    EXPECT_EQ(hash(s), before);
  };
  const std::array<float, 4> first{1, 0, 0, 0};
  const Eigen::Vector3f somewhere(0, 1, 0);
  refused([&](SurfacePatch& p) { p.vertices = {{99, somewhere, {}, first}}; });
  refused([&](SurfacePatch& p) { p.vertices = {{3, somewhere, {}, first}, {3, somewhere, {}, first}}; });
  refused([&](SurfacePatch& p) { p.vertices = {{3, somewhere, {0, 0, 99, 0}, first}}; });
  refused([&](SurfacePatch& p) { p.triangles = {{99, {0, 1, 2}, false}}; });
  refused([&](SurfacePatch& p) { p.triangles = {{0, {0, 1, 99}, false}}; });
  refused([&](SurfacePatch& p) { p.points.resize(max_streamed_points); });
  DrawnSurface less = s;
  less.rest.triangles.pop_back();
  EXPECT_THROW(difference(s, less), InternalError);
  less = s;
  less.streamed.rest[0].x() += 1;
  EXPECT_THROW(difference(s, less), InternalError);
}

}  // namespace
}  // namespace prosector
