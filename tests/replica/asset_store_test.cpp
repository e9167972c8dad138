#include "client/replica/asset_store.h"

#include <gtest/gtest.h>

#include <random>

namespace prosector {
namespace {

std::vector<AssetChunk> chunks_of(const std::vector<std::uint8_t>& bytes) {
  const auto count = static_cast<std::uint32_t>((bytes.size() + asset_chunk_bytes - 1) / asset_chunk_bytes);
  std::vector<AssetChunk> out;
  for (std::uint32_t c = 0; c < count; ++c) {
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(c * asset_chunk_bytes);
    const auto size = std::min(asset_chunk_bytes, bytes.size() - c * asset_chunk_bytes);
    out.push_back({content_hash(std::as_bytes(std::span(bytes))), c, count,
                   static_cast<std::uint32_t>(bytes.size()),
                   std::vector<std::uint8_t>(begin, begin + static_cast<std::ptrdiff_t>(size))});
  }
  return out;
}

std::vector<std::uint8_t> noise(std::size_t size) {
  std::mt19937 random(7);
  std::vector<std::uint8_t> out(size);
  for (auto& b : out) b = static_cast<std::uint8_t>(random());
  return out;
}

TEST(AssetStore, CompletesInAnyOrderAndWithDuplicates) {
  const auto bytes = noise(3 * asset_chunk_bytes + 17);
  auto chunks = chunks_of(bytes);
  std::swap(chunks[0], chunks[3]);
  AssetStore store;
  for (const auto& c : chunks) {
    EXPECT_FALSE(store.find(c.hash));
    store.add(c);
    if (&c != &chunks.back()) store.add(c);
  }
  const auto found = store.find(chunks[0].hash);
  ASSERT_TRUE(found);
  EXPECT_TRUE(std::equal(found->begin(), found->end(), bytes.begin(), bytes.end()));
  EXPECT_EQ(store.refused(), 0u);
}

TEST(AssetStore, RefusesBytesThatAreNotWhatTheirHashSays) {
  auto chunks = chunks_of(noise(1000));
  AssetChunk forged = chunks[0];
  forged.bytes[500] ^= 1;
  AssetStore store;
  store.add(forged);
  EXPECT_FALSE(store.find(forged.hash));
  EXPECT_EQ(store.refused(), 1u);
  store.add(chunks[0]);  // and can still be had afterwards
  EXPECT_TRUE(store.find(forged.hash));
}

TEST(AssetStore, RefusesChunksThatDoNotFit) {
  const auto chunks = chunks_of(noise(2 * asset_chunk_bytes));
  const auto refused = [&](auto change) {
    AssetChunk c = chunks[0];
    change(c);
    AssetStore store;
    store.add(c);
    return store.refused() == 1;
  };
  EXPECT_TRUE(refused([](AssetChunk& c) { c.chunk = 2; }));
  EXPECT_TRUE(refused([](AssetChunk& c) { c.chunks = 5; }));
  EXPECT_TRUE(refused([](AssetChunk& c) { c.total_bytes = 0; }));
  EXPECT_TRUE(refused([](AssetChunk& c) { c.total_bytes = 0xffffffffu; }));
  EXPECT_TRUE(refused([](AssetChunk& c) { c.bytes.pop_back(); }));
}

}  // namespace
}  // namespace prosector
