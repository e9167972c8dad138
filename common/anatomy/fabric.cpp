#include "common/anatomy/fabric.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

std::uint32_t pieces(double length, double cell) {
  return static_cast<std::uint32_t>(std::clamp(std::round(length / cell), 1.0, 1000.0));
}

void embed_nodes(Anatomy& out) {
  for (std::uint32_t i = 0; i < out.tets.positions.size(); ++i) {
    out.surface.positions.push_back(out.tets.positions[i]);
    out.embedding.rows.push_back({{i, i, i, i}, {1, 0, 0, 0}});
  }
}

}  // namespace

Anatomy make_sheet(const Vec3& size, double cell) {
  Anatomy out;
  out.thickness = size.y();
  const std::uint32_t nx = pieces(size.x(), cell), nz = pieces(size.z(), cell);
  for (std::uint32_t k = 0; k <= nz; ++k)
    for (std::uint32_t i = 0; i <= nx; ++i)
      out.tets.positions.emplace_back(size.x() * (1.0 * i / nx - 0.5), 0, size.z() * (1.0 * k / nz - 0.5));
  for (std::uint32_t k = 0; k < nz; ++k)
    for (std::uint32_t i = 0; i < nx; ++i) {
      const std::uint32_t a = k * (nx + 1) + i;
      out.quads.push_back({a, a + nx + 1, a + nx + 2, a + 1});
    }
  embed_nodes(out);
  embed_nodes(out);
  const auto below = static_cast<std::uint32_t>(out.tets.positions.size());
  for (const auto& q : out.quads) {
    out.surface.triangles.push_back({q[0], q[1], q[2]});
    out.surface.triangles.push_back({q[0], q[2], q[3]});
    out.surface.triangles.push_back({below + q[0], below + q[2], below + q[1]});
    out.surface.triangles.push_back({below + q[0], below + q[3], below + q[2]});
  }
  return out;
}

Anatomy make_rope(const Vec3& size, double cell) {
  Anatomy out;
  out.thickness = size.y();
  const std::uint32_t n = pieces(size.x(), cell);
  for (std::uint32_t i = 0; i <= n; ++i)
    out.tets.positions.emplace_back(size.x() * (1.0 * i / n - 0.5), 0, 0);
  for (std::uint32_t i = 0; i < n; ++i) out.segments.push_back({i, i + 1});
  embed_nodes(out);
  return out;
}

}  // namespace prosector
