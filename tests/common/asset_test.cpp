#include "common/asset.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "common/error.h"
#include "tests/common/asset_samples.h"

namespace prosector {
namespace {

using namespace testing_assets;

TEST(Asset, MeshesRoundTrip) {
  std::mt19937_64 random(1);
  for (const std::uint32_t n : {0u, 1u, 3u, 500u}) {
    const TriangleMesh mesh = random_mesh(random, n, 2 * n);
    const Asset asset = encode(mesh);
    const TriangleMesh back = decode_triangle_mesh(asset.bytes);
    EXPECT_EQ(back.triangles, mesh.triangles);
    ASSERT_EQ(back.positions.size(), mesh.positions.size());
    for (std::size_t v = 0; v < n; ++v)
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(back.positions[v][k], static_cast<double>(static_cast<float>(mesh.positions[v][k])));
    // What was decoded encodes to the same bytes, and so to the same name.
    EXPECT_EQ(encode(back).bytes, asset.bytes);
    EXPECT_EQ(encode(back).hash, asset.hash);
  }
}

TEST(Asset, MapsRoundTrip) {
  std::mt19937_64 random(2);
  for (const std::uint32_t n : {0u, 1u, 300u}) {
    const SparseMap map = random_map(random, n, 1000);
    const Asset asset = encode(map);
    const SparseMap back = decode_sparse_map(asset.bytes);
    ASSERT_EQ(back.rows.size(), map.rows.size());
    for (std::size_t r = 0; r < n; ++r) {
      EXPECT_EQ(back.rows[r].node, map.rows[r].node);
      for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(back.rows[r].weight[k], map.rows[r].weight[k], 1e-6);
    }
    EXPECT_EQ(encode(back).hash, asset.hash);
  }
}

TEST(Asset, EveryTruncationAndEveryTailIsRefused) {
  std::mt19937_64 random(3);
  auto mesh = encode(random_mesh(random, 6, 8)).bytes, map = encode(random_map(random, 5, 9)).bytes;
  for (std::size_t n = 0; n < mesh.size(); ++n)
    EXPECT_THROW(decode_triangle_mesh(std::span(mesh).first(n)), InputError) << n;
  for (std::size_t n = 0; n < map.size(); ++n)
    EXPECT_THROW(decode_sparse_map(std::span(map).first(n)), InputError) << n;
  EXPECT_THROW(decode_sparse_map(mesh), InputError);
  EXPECT_THROW(decode_triangle_mesh(map), InputError);
  mesh.push_back(0);
  map.push_back(0);
  EXPECT_THROW(decode_triangle_mesh(mesh), InputError);
  EXPECT_THROW(decode_sparse_map(map), InputError);
}

TEST(Asset, LiesAreRefused) {
  std::mt19937_64 random(4);
  const auto good = encode(random_mesh(random, 6, 8)).bytes;
  const auto with = [](std::vector<std::uint8_t> bytes, std::size_t at, auto value) {
    std::memcpy(bytes.data() + at, &value, sizeof(value));
    return bytes;
  };
  EXPECT_THROW(decode_triangle_mesh(with(good, 4, std::uint32_t{0xffffffff})), InputError);
  EXPECT_THROW(decode_triangle_mesh(with(good, 8, std::numeric_limits<float>::quiet_NaN())), InputError);
  EXPECT_THROW(decode_triangle_mesh(with(good, 8, 1e9f)), InputError);
  EXPECT_THROW(decode_triangle_mesh(with(good, good.size() - 4, std::uint32_t{6})), InputError);
  const auto map = encode(random_map(random, 1, 9)).bytes;
  EXPECT_THROW(decode_sparse_map(with(map, 8, std::uint32_t{1u << 24})), InputError);
  EXPECT_THROW(decode_sparse_map(with(map, 24, 5.f)), InputError);  // the sum isn't 1
  EXPECT_THROW(decode_sparse_map(with(map, 24, std::numeric_limits<float>::infinity())), InputError);
}

}  // namespace
}  // namespace prosector
