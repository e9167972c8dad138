#pragma once
// Collects AssetChunks until an asset is complete and its bytes match its content hash.

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "common/hash.h"
#include "common/scene_messages.h"

namespace prosector {

class AssetStore {
 public:
  /// Adds a chunk. A chunk that does not fit its asset (other count or size) is ignored and counted. If a
  /// complete asset's hash is wrong, all its chunks are discarded, so that it can be sent again.
  void add(const AssetChunk& chunk);
  /// Returns the asset's bytes if it is complete and verified, else nullopt.
  std::optional<std::span<const std::uint8_t>> find(const ContentHash& hash) const;
  /// Returns the received fraction of the asset, 0 … 1.
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
