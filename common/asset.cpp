#include "common/asset.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "common/error.h"

namespace prosector {
namespace {

constexpr std::uint32_t mesh_magic = 0x314d5350;      // "PSM1"
constexpr std::uint32_t cut_mesh_magic = 0x324d5350;  // "PSM2": with inner triangles
constexpr std::uint32_t surface_magic = 0x32575350;   // "PSW2"
constexpr float max_position = 1000.f;                // m

template <class T>
void put(std::vector<std::uint8_t>& out, T value) {
  const auto* p = reinterpret_cast<const std::uint8_t*>(&value);
  out.insert(out.end(), p, p + sizeof(T));
}

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  template <class T>
  T get() {
    if (bytes_.size() - at_ < sizeof(T)) throw InputError("asset: truncated");
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  /// Reads a count of records of `size` bytes that must still fit, so that a lie cannot make us allocate.
  std::uint32_t count(std::size_t size) {
    const auto n = get<std::uint32_t>();
    if (n > (bytes_.size() - at_) / size) throw InputError(fmt::format("asset: {} records do not fit", n));
    return n;
  }
  void end() const {
    if (at_ != bytes_.size()) throw InputError(fmt::format("asset: {} bytes too many", bytes_.size() - at_));
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

Asset finish(std::vector<std::uint8_t> bytes) {
  Asset out;
  out.hash = content_hash(std::as_bytes(std::span(bytes)));
  out.bytes = std::move(bytes);
  return out;
}

void put_positions(std::vector<std::uint8_t>& out, const std::vector<Vec3>& positions) {
  put(out, static_cast<std::uint32_t>(positions.size()));
  for (const Vec3& x : positions)
    for (int k = 0; k < 3; ++k) put(out, static_cast<float>(x[k]));
}

std::vector<Vec3> get_positions(Reader& in) {
  std::vector<Vec3> positions(in.count(12));
  for (Vec3& x : positions)
    for (int k = 0; k < 3; ++k) {
      const auto value = in.get<float>();
      if (!(std::abs(value) <= max_position)) throw InputError("asset: position out of range");
      x[k] = static_cast<double>(value);
    }
  return positions;
}

}  // namespace

Asset encode(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> out;
  const bool cut = !mesh.inner.empty();
  if (cut && mesh.inner.size() != mesh.triangles.size())
    throw InputError(fmt::format("mesh: {} flags of inner triangles for {} triangles", mesh.inner.size(),
                                 mesh.triangles.size()));
  out.reserve(12 + mesh.positions.size() * 12 + mesh.triangles.size() * 12 + mesh.inner.size());
  put(out, cut ? cut_mesh_magic : mesh_magic);
  put_positions(out, mesh.positions);
  put(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles)
    for (auto i : t) put(out, i);
  out.insert(out.end(), mesh.inner.begin(), mesh.inner.end());
  return finish(std::move(out));
}

TriangleMesh decode_triangle_mesh(std::span<const std::uint8_t> bytes) {
  Reader in(bytes);
  const auto magic = in.get<std::uint32_t>();
  if (magic != mesh_magic && magic != cut_mesh_magic) throw InputError("asset: not a triangle mesh");
  TriangleMesh mesh;
  mesh.positions = get_positions(in);
  mesh.triangles.resize(in.count(12));
  for (auto& t : mesh.triangles)
    for (auto& i : t) {
      i = in.get<std::uint32_t>();
      if (i >= mesh.positions.size())
        throw InputError(fmt::format("asset: vertex {} of {}", i, mesh.positions.size()));
    }
  if (magic == cut_mesh_magic) {
    mesh.inner.resize(mesh.triangles.size());
    for (auto& flag : mesh.inner) {
      flag = in.get<std::uint8_t>();
      if (flag > 1) throw InputError(fmt::format("asset: {} is no flag of an inner triangle", flag));
    }
  }
  in.end();
  return mesh;
}

Asset encode(const StreamedSurface& surface) {
  std::vector<std::uint8_t> out;
  out.reserve(12 + surface.rest.size() * 12 + surface.map.rows.size() * 32);
  put(out, surface_magic);
  put_positions(out, surface.rest);
  put(out, static_cast<std::uint32_t>(surface.map.rows.size()));
  for (const SparseMap::Row& row : surface.map.rows) {
    for (auto node : row.node) put(out, node);
    for (double weight : row.weight) put(out, static_cast<float>(weight));
  }
  return finish(std::move(out));
}

StreamedSurface decode_streamed_surface(std::span<const std::uint8_t> bytes) {
  Reader in(bytes);
  if (in.get<std::uint32_t>() != surface_magic) throw InputError("asset: not a streamed surface");
  StreamedSurface surface;
  surface.rest = get_positions(in);
  surface.map.rows.resize(in.count(32));
  for (SparseMap::Row& row : surface.map.rows) {
    for (auto& node : row.node) {
      node = in.get<std::uint32_t>();
      if (node >= surface.rest.size()) throw InputError("asset: point index out of range");
    }
    double sum = 0;
    for (double& weight : row.weight) {
      weight = static_cast<double>(in.get<float>());
      if (!(std::abs(weight) <= 16)) throw InputError("asset: weight out of range");
      sum += weight;
    }
    if (!(std::abs(sum - 1) < 1e-4)) throw InputError("asset: weights do not sum to 1");
  }
  in.end();
  return surface;
}

}  // namespace prosector
