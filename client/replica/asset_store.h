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
  /// Adds a received chunk of an asset (a mesh or map of the scene). A chunk whose count or size does not fit
  /// its asset is ignored and counted. If the bytes of a completed asset do not match its content hash, all
  /// its chunks are discarded, so that it can be sent again.
  void add(const AssetChunk& chunk);
  /// Returns the bytes of the asset with this content hash, or nullopt if it is incomplete or unverified.
  std::optional<std::span<const std::uint8_t>> find(const ContentHash& hash) const;
  /// Returns the received fraction of the asset with this content hash, 0 … 1.
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
