#pragma once
// Meshes and maps as bytes with a content hash: what AssetChunk carries and what caches hold.
// Little endian; positions as float32. Decoding trusts nothing: sizes, indices, finiteness and weights are
// checked.

#include <cstdint>
#include <span>
#include <vector>

#include "common/hash.h"
#include "common/mesh.h"

namespace prosector {

struct Asset {
  ContentHash hash{};
  std::vector<std::uint8_t> bytes;
};

Asset encode(const TriangleMesh& mesh);
Asset encode(const SparseMap& map);

/// Throw InputError when the bytes are no such asset.
TriangleMesh decode_triangle_mesh(std::span<const std::uint8_t> bytes);
SparseMap decode_sparse_map(std::span<const std::uint8_t> bytes);

}  // namespace prosector
