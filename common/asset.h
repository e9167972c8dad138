#pragma once
// Meshes and surface embeddings encoded as bytes with a content hash: the payload of AssetChunk and the
// content of caches. Little endian; positions as float32. Decoding checks all sizes, indices, weights, and
// that numbers are finite.

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

/// Rest positions of a soft body's streamed points, and the map from these points to the vertices of its
/// drawn surface. Positions in SoftState messages are relative to these rest positions.
struct StreamedSurface {
  std::vector<Vec3> rest;  // metres, world frame; float32 when encoded
  SparseMap map;           // surface vertex ← streamed points
};

Asset encode(const TriangleMesh& mesh);
Asset encode(const StreamedSurface& surface);

/// Decodes a mesh or a streamed surface from the bytes that encode() made of it. Throws InputError if the
/// bytes are not a valid asset of that type.
TriangleMesh decode_triangle_mesh(std::span<const std::uint8_t> bytes);
StreamedSurface decode_streamed_surface(std::span<const std::uint8_t> bytes);

}  // namespace prosector
