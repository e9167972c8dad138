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

TEST(Asset, InnerTrianglesRoundTripAndUncutMeshesKeepTheirNames) {
  std::mt19937_64 random(7);
  TriangleMesh mesh = random_mesh(random, 9, 12);
  const Asset uncut = encode(mesh);
  EXPECT_EQ(uncut.bytes.size(), 12 + 9 * 12 + 12 * 12u);  // as before there were cuts
  mesh.inner.assign(12, 0);
  mesh.inner[7] = 1;
  const Asset cut = encode(mesh);
  EXPECT_NE(cut.hash, uncut.hash);
  EXPECT_EQ(decode_triangle_mesh(cut.bytes).inner, mesh.inner);
  EXPECT_TRUE(decode_triangle_mesh(uncut.bytes).inner.empty());
  auto bytes = cut.bytes;
  bytes.back() = 2;
  EXPECT_THROW(decode_triangle_mesh(bytes), InputError);
  bytes.pop_back();
  EXPECT_THROW(decode_triangle_mesh(bytes), InputError);
  mesh.inner.pop_back();
  EXPECT_THROW(encode(mesh), InternalError);
}

TEST(Asset, StreamedSurfacesRoundTrip) {
  std::mt19937_64 random(2);
  for (const std::uint32_t n : {0u, 1u, 300u}) {
    const StreamedSurface surface = random_surface(random, n, 1000);
    const Asset asset = encode(surface);
    const StreamedSurface back = decode_streamed_surface(asset.bytes);
    ASSERT_EQ(back.rest.size(), surface.rest.size());
    for (std::size_t i = 0; i < back.rest.size(); ++i)
      EXPECT_EQ(back.rest[i], surface.rest[i].cast<float>().cast<double>());
    ASSERT_EQ(back.map.rows.size(), n);
    for (std::size_t r = 0; r < n; ++r) {
      EXPECT_EQ(back.map.rows[r].node, surface.map.rows[r].node);
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(back.map.rows[r].weight[k], surface.map.rows[r].weight[k], 1e-6);
    }
    EXPECT_EQ(encode(back).hash, asset.hash);
  }
}

TEST(Asset, EveryTruncationAndEveryTailIsRefused) {
  std::mt19937_64 random(3);
  auto mesh = encode(random_mesh(random, 6, 8)).bytes, map = encode(random_surface(random, 5, 9)).bytes;
  for (std::size_t n = 0; n < mesh.size(); ++n)
    EXPECT_THROW(decode_triangle_mesh(std::span(mesh).first(n)), InputError) << n;
  for (std::size_t n = 0; n < map.size(); ++n)
    EXPECT_THROW(decode_streamed_surface(std::span(map).first(n)), InputError) << n;
  EXPECT_THROW(decode_streamed_surface(mesh), InputError);
  EXPECT_THROW(decode_triangle_mesh(map), InputError);
  mesh.push_back(0);
  map.push_back(0);
  EXPECT_THROW(decode_triangle_mesh(mesh), InputError);
  EXPECT_THROW(decode_streamed_surface(map), InputError);
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
  const auto map = encode(random_surface(random, 1, 9)).bytes;
  const std::size_t row = 8 + 9 * 12 + 4;
  EXPECT_THROW(decode_streamed_surface(with(map, 4, std::uint32_t{0xffffffff})), InputError);
  EXPECT_THROW(decode_streamed_surface(with(map, 8, 1e9f)), InputError);
  EXPECT_THROW(decode_streamed_surface(with(map, row, std::uint32_t{9})), InputError);
  EXPECT_THROW(decode_streamed_surface(with(map, row + 16, 5.f)), InputError);  // the sum isn't 1
  EXPECT_THROW(decode_streamed_surface(with(map, row + 16, std::numeric_limits<float>::infinity())),
               InputError);
}

}  // namespace
}  // namespace prosector
