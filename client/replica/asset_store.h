#pragma once
// Gathers AssetChunks until a whole asset is there and its bytes have the hash they were announced under.

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "common/hash.h"
#include "common/messages.h"

namespace prosector {

class AssetStore {
 public:
  /// Takes a chunk; one that fits no asset (other count, other size) is ignored and counted. When the last
  /// chunk completes an asset whose hash is wrong, all its chunks are dropped, so that it can be sent again.
  void add(const AssetChunk& chunk);
  /// Returns the asset's bytes once complete and proven, else nullopt.
  std::optional<std::span<const std::uint8_t>> find(const ContentHash& hash) const;
  /// Returns how much of the asset has arrived, 0 … 1.
  double share(const ContentHash& hash) const;
  std::size_t refused() const { return refused_; }

 private:
  struct Partial {
    std::uint32_t chunks = 0;
    std::vector<std::uint8_t> bytes;
    std::vector<bool> have;
    std::uint32_t missing = 0;
  };
  std::map<ContentHash, Partial> partial_;
  std::map<ContentHash, std::vector<std::uint8_t>> complete_;
  std::size_t refused_ = 0;
};

}  // namespace prosector
