#pragma once
// Meshes and what surfaces hang on, as bytes with a content hash: what AssetChunk carries and what caches
// hold. Little endian; positions as float32. Decoding trusts nothing: sizes, indices, finiteness and weights
// are checked.

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

/// The places of a deformable's streamed points at rest, and how its surface hangs on them: what SoftState is
/// relative to.
struct StreamedSurface {
  std::vector<Vec3> rest;  // metres, world frame; float32 when encoded
  SparseMap map;           // surface vertex ← streamed points
};

Asset encode(const TriangleMesh& mesh);
Asset encode(const StreamedSurface& surface);

/// Decodes what encode() made. Throws InputError when the bytes are no such asset.
TriangleMesh decode_triangle_mesh(std::span<const std::uint8_t> bytes);
StreamedSurface decode_streamed_surface(std::span<const std::uint8_t> bytes);

}  // namespace prosector
