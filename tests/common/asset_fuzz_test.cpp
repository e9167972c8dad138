// Mutated assets: each decodes to something valid or is refused with InputError.

#include <gtest/gtest.h>

#include "common/asset.h"
#include "common/error.h"
#include "tests/common/asset_samples.h"

namespace prosector {
namespace {

using namespace testing_assets;

std::vector<std::uint8_t> mutated(std::vector<std::uint8_t> bytes, std::mt19937_64& random) {
  for (auto changes = random() % 4; changes > 0; --changes) {
    const std::size_t at = random() % bytes.size();
    if (random() % 2 == 0)
      bytes[at] = static_cast<std::uint8_t>(random());
    else
      bytes[at] ^= static_cast<std::uint8_t>(1u << (random() % 8));
  }
  if (random() % 8 == 0) bytes.resize(random() % (2 * bytes.size()));
  return bytes;
}

TEST(AssetFuzz, Meshes) {
  std::mt19937_64 random(5);
  TriangleMesh whole = random_mesh(random, 20, 30), cut = whole;
  cut.inner.assign(30, 1);
  const std::array seeds = {encode(whole).bytes, encode(cut).bytes};
  int decoded = 0, refused = 0;
  for (std::size_t n = 0; n < 50000; ++n) {
    try {
      const TriangleMesh mesh = decode_triangle_mesh(mutated(seeds[n % 2], random));
      ASSERT_TRUE(mesh.inner.empty() || mesh.inner.size() == mesh.triangles.size());
      for (const Vec3& x : mesh.positions) ASSERT_TRUE(is_finite(x));
      for (const auto& t : mesh.triangles)
        for (const auto v : t) ASSERT_LT(v, mesh.positions.size());
      ++decoded;
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(decoded, 1000);
  EXPECT_GT(refused, 1000);
}

TEST(AssetFuzz, StreamedSurfaces) {
  std::mt19937_64 random(6);
  const auto seed = encode(random_surface(random, 20, 50)).bytes;
  int decoded = 0, refused = 0;
  for (int n = 0; n < 50000; ++n) {
    try {
      const StreamedSurface surface = decode_streamed_surface(mutated(seed, random));
      for (const Vec3& x : surface.rest) ASSERT_TRUE(is_finite(x));
      for (const auto& row : surface.map.rows) {
        for (const auto point : row.node) ASSERT_LT(point, surface.rest.size());
        ASSERT_NEAR(row.weight[0] + row.weight[1] + row.weight[2] + row.weight[3], 1, 1e-4);
      }
      ++decoded;
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(decoded, 1000);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace prosector
