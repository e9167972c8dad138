#include "client/replica/asset_store.h"

#include <algorithm>

#include "common/assert.h"

namespace prosector {
namespace {

bool plausible(const AssetChunk& c) {
  if (c.total_bytes == 0 || c.total_bytes > max_asset_bytes || c.chunk >= c.chunks) return false;
  const std::size_t expected_chunks = (c.total_bytes + asset_chunk_bytes - 1) / asset_chunk_bytes;
  const std::size_t offset = c.chunk * asset_chunk_bytes;
  return c.chunks == expected_chunks && c.bytes.size() == std::min(asset_chunk_bytes, c.total_bytes - offset);
}

}  // namespace

void AssetStore::add(const AssetChunk& chunk) {
  if (complete_.contains(chunk.hash)) return;
  if (!plausible(chunk)) {
    ++refused_;
    return;
  }
  Partial& p = partial_[chunk.hash];
  if (p.chunks == 0) {
    p.chunks = p.missing = chunk.chunks;
    p.bytes.resize(chunk.total_bytes);
    p.have.assign(chunk.chunks, false);
  }
  if (p.bytes.size() != chunk.total_bytes) {
    ++refused_;
    return;
  }
  PROSECTOR_ASSERT(p.have.size() == chunk.chunks && p.missing > 0);
  if (p.have[chunk.chunk]) return;
  std::copy(chunk.bytes.begin(), chunk.bytes.end(),
            p.bytes.begin() + static_cast<std::ptrdiff_t>(chunk.chunk * asset_chunk_bytes));
  p.have[chunk.chunk] = true;
  if (--p.missing > 0) return;
  if (content_hash(std::as_bytes(std::span(p.bytes))) == chunk.hash)
    complete_.emplace(chunk.hash, std::move(p.bytes));
  else
    ++refused_;
  partial_.erase(chunk.hash);
}

std::optional<std::span<const std::uint8_t>> AssetStore::find(const ContentHash& hash) const {
  const auto it = complete_.find(hash);
  if (it == complete_.end()) return std::nullopt;
  return std::span<const std::uint8_t>(it->second);
}

double AssetStore::share(const ContentHash& hash) const {
  if (complete_.contains(hash)) return 1;
  const auto partial = partial_.find(hash);
  if (partial == partial_.end()) return 0;
  PROSECTOR_ASSERT(partial->second.missing <= partial->second.chunks && partial->second.chunks > 0);
  return 1 - static_cast<double>(partial->second.missing) / partial->second.chunks;
}

}  // namespace prosector
