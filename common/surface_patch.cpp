#include "common/surface_patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "common/assert.h"
#include "common/error.h"

namespace prosector {
namespace {

using Corners = std::array<std::uint32_t, 3>;

bool is_inner(const TriangleMesh& mesh, std::size_t triangle) {
  return !mesh.inner.empty() && mesh.inner[triangle] != 0;
}

/// Bit pattern of a surface vertex, for comparison: −0 differs from 0.
struct VertexBits {
  std::array<float, 3> rest;
  std::array<std::uint32_t, 4> point;
  std::array<float, 4> weight;
  bool operator==(const VertexBits& o) const { return std::memcmp(this, &o, sizeof o) == 0; }
};
static_assert(sizeof(VertexBits) == 44);

VertexBits bits_of(const DrawnSurface& surface, std::size_t vertex) {
  const Vec3& x = surface.rest.positions[vertex];
  const SparseMap::Row& row = surface.streamed.map.rows[vertex];
  VertexBits out{.rest = {static_cast<float>(x.x()), static_cast<float>(x.y()), static_cast<float>(x.z())},
                 .point = row.node,
                 .weight = {}};
  for (std::size_t k = 0; k < 4; ++k) out.weight[k] = static_cast<float>(row.weight[k]);
  return out;
}

struct TriangleBits {
  Corners corners;
  std::uint32_t inner;
  bool operator==(const TriangleBits&) const = default;
};

TriangleBits bits_of(const TriangleMesh& mesh, std::size_t triangle) {
  return {mesh.triangles[triangle], is_inner(mesh, triangle) ? 1U : 0U};
}

/// Returns the number of slots after `entries` are applied. Entries may only set existing slots or append
/// slots one by one. Throws InputError otherwise.
template <class Entry>
std::size_t count_after(std::size_t count, const std::vector<Entry>& entries, const char* what) {
  std::uint64_t least = 0;
  for (const Entry& entry : entries) {
    if (entry.slot < least || entry.slot > count)
      throw InputError(fmt::format("surface patch: {} slot {} of {}", what, entry.slot, count));
    count = std::max<std::size_t>(count, entry.slot + std::size_t{1});
    least = entry.slot + std::uint64_t{1};
  }
  return count;
}

bool has_rows_for_its_vertices(const DrawnSurface& surface) {
  return surface.streamed.map.rows.size() == surface.rest.positions.size();
}

void check(const SurfacePatch& patch, const DrawnSurface& surface) {
  PROSECTOR_ASSERT(has_rows_for_its_vertices(surface));
  const std::size_t points = surface.streamed.rest.size() + patch.points.size();
  const std::size_t vertices = count_after(surface.rest.positions.size(), patch.vertices, "vertex");
  const std::size_t triangles = count_after(surface.rest.triangles.size(), patch.triangles, "triangle");
  if (points > max_streamed_points || vertices > max_surface_vertices || triangles > max_surface_triangles)
    throw InputError(fmt::format(
        "surface patch: the surface would have {} points, {} vertices and {} triangles; allowed: at most {}, "
        "{} and {}",
        points, vertices, triangles, max_streamed_points, max_surface_vertices, max_surface_triangles));
  for (const auto& vertex : patch.vertices)
    for (const std::uint32_t point : vertex.point)
      if (point >= points)
        throw InputError(fmt::format(
            "surface patch: a vertex refers to point {}, but there are {} points, numbered from 0", point,
            points));
  for (const auto& triangle : patch.triangles)
    for (const std::uint32_t corner : triangle.corners)
      if (corner >= vertices)
        throw InputError(fmt::format(
            "surface patch: a triangle refers to vertex {}, but there are {} vertices, numbered from 0",
            corner, vertices));
}

}  // namespace

// Not inlined: when GCC 12 vectorises two lanes, it removes the two conversions.
[[gnu::noinline]] double to_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

Vec3 to_float(const Vec3& x) {
  return {to_float(x.x()), to_float(x.y()), to_float(x.z())};
}

DrawnSurface rounded(TriangleMesh rest, StreamedSurface streamed) {
  for (Vec3& x : rest.positions) x = to_float(x);
  for (Vec3& x : streamed.rest) x = to_float(x);
  for (SparseMap::Row& row : streamed.map.rows)
    for (double& weight : row.weight) weight = to_float(weight);
  return {std::move(rest), std::move(streamed)};
}

SurfacePatch difference(const DrawnSurface& before, const DrawnSurface& after) {
  PROSECTOR_ASSERT(has_rows_for_its_vertices(before) && has_rows_for_its_vertices(after));
  const std::size_t points = before.streamed.rest.size(), vertices = before.rest.positions.size(),
                    triangles = before.rest.triangles.size();
  if (after.streamed.rest.size() < points || after.rest.positions.size() < vertices ||
      after.rest.triangles.size() < triangles)
    throw InternalError(
        "surface patch: the new surface has fewer points, vertices or triangles than the old one; they may "
        "only be added");
  SurfacePatch out;
  for (std::size_t i = 0; i < after.streamed.rest.size(); ++i) {
    const Eigen::Vector3f rest = after.streamed.rest[i].cast<float>();
    if (i >= points)
      out.points.push_back({rest, rest});
    else if (rest != before.streamed.rest[i].cast<float>())
      throw InternalError(fmt::format(
          "surface patch: the rest position of point {} differs between the surfaces; it must not change",
          i));
  }
  for (std::size_t v = 0; v < after.rest.positions.size(); ++v) {
    const VertexBits now = bits_of(after, v);
    if (v < vertices && now == bits_of(before, v)) continue;
    out.vertices.push_back(
        {static_cast<std::uint32_t>(v), {now.rest[0], now.rest[1], now.rest[2]}, now.point, now.weight});
  }
  for (std::size_t t = 0; t < after.rest.triangles.size(); ++t) {
    const TriangleBits now = bits_of(after.rest, t);
    if (t < triangles && now == bits_of(before.rest, t)) continue;
    out.triangles.push_back({static_cast<std::uint32_t>(t), now.corners, now.inner != 0});
  }
  return out;
}

void apply(const SurfacePatch& patch, DrawnSurface& surface) {
  check(patch, surface);
  TriangleMesh& mesh = surface.rest;
  StreamedSurface& streamed = surface.streamed;
  for (const auto& point : patch.points) streamed.rest.push_back(point.rest.cast<double>());
  for (const auto& vertex : patch.vertices) {
    if (vertex.slot == mesh.positions.size()) {
      mesh.positions.emplace_back();
      streamed.map.rows.emplace_back();
    }
    mesh.positions[vertex.slot] = vertex.rest.cast<double>();
    SparseMap::Row& row = streamed.map.rows[vertex.slot];
    row.node = vertex.point;
    for (std::size_t k = 0; k < 4; ++k) row.weight[k] = static_cast<double>(vertex.weight[k]);
  }
  for (const auto& triangle : patch.triangles) {
    if (triangle.slot == mesh.triangles.size()) {
      mesh.triangles.emplace_back();
      if (!mesh.inner.empty()) mesh.inner.push_back(0);
    }
    mesh.triangles[triangle.slot] = triangle.corners;
    if (triangle.inner) mesh.inner.resize(mesh.triangles.size(), 0);
    if (!mesh.inner.empty()) mesh.inner[triangle.slot] = triangle.inner ? 1 : 0;
  }
}

std::uint64_t hash(const DrawnSurface& surface) {
  PROSECTOR_ASSERT(has_rows_for_its_vertices(surface));
  StateHasher hasher;
  hasher.add(surface.streamed.rest.size());
  hasher.add(surface.rest.positions.size());
  hasher.add(surface.rest.triangles.size());
  const auto add = [&](const auto& bits) { hasher.add(std::as_bytes(std::span(&bits, 1))); };
  for (const Vec3& x : surface.streamed.rest) add(Eigen::Vector3f(x.cast<float>()));
  for (std::size_t v = 0; v < surface.rest.positions.size(); ++v) add(bits_of(surface, v));
  for (std::size_t t = 0; t < surface.rest.triangles.size(); ++t) add(bits_of(surface.rest, t));
  return hasher.digest();
}

std::uint64_t chain_hash_of(const TopologyRevision& revision) {
  StateHasher chain;
  chain.add(revision.previous_hash);
  chain.add(revision.content_hash);
  chain.add(revision.surface_hash);
  chain.add(revision.revision);
  chain.add(revision.body);
  return chain.digest();
}

}  // namespace prosector
