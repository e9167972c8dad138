#include "common/asset.h"

#include <fmt/format.h>

#include <cmath>

#include "common/byte_stream.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::uint32_t mesh_magic = 0x314d5350;      // "PSM1"
constexpr std::uint32_t cut_mesh_magic = 0x324d5350;  // "PSM2": with inner triangles
constexpr std::uint32_t surface_magic = 0x32575350;   // "PSW2"
constexpr float max_position = 1000.f;                // m

Asset finish(ByteWriter& out) {
  Asset asset;
  asset.bytes = out.take();
  asset.hash = content_hash(std::as_bytes(std::span(asset.bytes)));
  return asset;
}

void put_positions(ByteWriter& out, const std::vector<Vec3>& positions) {
  out.add(static_cast<std::uint32_t>(positions.size()));
  for (const Vec3& x : positions)
    for (int k = 0; k < 3; ++k) out.add(static_cast<float>(x[k]));
}

std::vector<Vec3> get_positions(ByteReader& in) {
  std::vector<Vec3> positions(in.records(12));
  for (Vec3& x : positions)
    for (int k = 0; k < 3; ++k) {
      const auto value = in.bits<float>();
      if (!(std::abs(value) <= max_position))
        throw InputError("asset: a coordinate of a vertex position is out of range");
      x[k] = static_cast<double>(value);
    }
  return positions;
}

}  // namespace

Asset encode(const TriangleMesh& mesh) {
  ByteWriter out;
  const bool cut = !mesh.inner.empty();
  if (cut && mesh.inner.size() != mesh.triangles.size())
    throw InternalError(fmt::format(
        "mesh: {} flags mark inner triangles, but there are {} triangles; the numbers must be equal",
        mesh.inner.size(), mesh.triangles.size()));
  out.reserve(12 + mesh.positions.size() * 12 + mesh.triangles.size() * 12 + mesh.inner.size());
  out.add(cut ? cut_mesh_magic : mesh_magic);
  put_positions(out, mesh.positions);
  out.add(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles)
    for (auto i : t) out.add(i);
  out.raw(mesh.inner.data(), mesh.inner.size());
  return finish(out);
}

TriangleMesh decode_triangle_mesh(std::span<const std::uint8_t> bytes) {
  ByteReader in(bytes, "asset");
  const auto magic = in.bits<std::uint32_t>();
  if (magic != mesh_magic && magic != cut_mesh_magic) throw InputError("asset: not a triangle mesh");
  TriangleMesh mesh;
  mesh.positions = get_positions(in);
  mesh.triangles.resize(in.records(12));
  for (auto& t : mesh.triangles)
    for (auto& i : t) {
      i = in.bits<std::uint32_t>();
      if (i >= mesh.positions.size())
        throw InputError(fmt::format("asset: vertex {} of {}", i, mesh.positions.size()));
    }
  if (magic == cut_mesh_magic) {
    mesh.inner.resize(mesh.triangles.size());
    for (auto& flag : mesh.inner) {
      flag = in.bits<std::uint8_t>();
      if (flag > 1)
        throw InputError(
            fmt::format("asset: the flag that marks an inner triangle is {}; allowed: 0 or 1", flag));
    }
  }
  in.end();
  return mesh;
}

Asset encode(const StreamedSurface& surface) {
  ByteWriter out;
  out.reserve(12 + surface.rest.size() * 12 + surface.map.rows.size() * 32);
  out.add(surface_magic);
  put_positions(out, surface.rest);
  out.add(static_cast<std::uint32_t>(surface.map.rows.size()));
  for (const SparseMap::Row& row : surface.map.rows) {
    for (auto node : row.node) out.add(node);
    for (double weight : row.weight) out.add(static_cast<float>(weight));
  }
  return finish(out);
}

StreamedSurface decode_streamed_surface(std::span<const std::uint8_t> bytes) {
  ByteReader in(bytes, "asset");
  if (in.bits<std::uint32_t>() != surface_magic) throw InputError("asset: not a streamed surface");
  StreamedSurface surface;
  surface.rest = get_positions(in);
  surface.map.rows.resize(in.records(32));
  for (SparseMap::Row& row : surface.map.rows) {
    for (auto& node : row.node) {
      node = in.bits<std::uint32_t>();
      if (node >= surface.rest.size())
        throw InputError("asset: a vertex refers to a point that does not exist");
    }
    double sum = 0;
    for (double& weight : row.weight) {
      weight = static_cast<double>(in.bits<float>());
      if (!(std::abs(weight) <= 16)) throw InputError("asset: a weight of a vertex is out of range");
      sum += weight;
    }
    if (!(std::abs(sum - 1) < 1e-4)) throw InputError("asset: the sum of a vertex's weights is not 1");
  }
  in.end();
  return surface;
}

}  // namespace prosector
