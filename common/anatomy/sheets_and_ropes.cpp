#include "common/anatomy/sheets_and_ropes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/curves/tube.h"
#include "common/error.h"

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

/// Makes a sheet from nodes given row by row, each row with `columns` nodes along u.
Anatomy sheet_of(std::vector<Vec3> nodes, std::uint32_t columns, double thickness) {
  Anatomy out;
  out.thickness = thickness;
  out.tets.positions = std::move(nodes);
  const auto rows = static_cast<std::uint32_t>(out.tets.positions.size()) / columns;
  for (std::uint32_t k = 0; k + 1 < rows; ++k)
    for (std::uint32_t i = 0; i + 1 < columns; ++i) {
      const std::uint32_t a = k * columns + i;
      out.quads.push_back({a, a + columns, a + columns + 1, a + 1});
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

Anatomy rope_of(std::vector<Vec3> nodes, double diameter) {
  Anatomy out;
  out.thickness = diameter;
  out.tets.positions = std::move(nodes);
  for (std::uint32_t i = 0; i + 1 < out.tets.positions.size(); ++i) out.segments.push_back({i, i + 1});
  embed_nodes(out);
  return out;
}

/// Returns the mean length of the patch's u (or v) lines.
double mean_length(const Patch& patch, bool along_u) {
  constexpr int lines = 8, steps = 32;
  double sum = 0;
  for (int line = 0; line <= lines; ++line)
    for (int step = 0; step < steps; ++step) {
      const double across = 1.0 * line / lines, from = 1.0 * step / steps, to = 1.0 * (step + 1) / steps;
      const Vec3 a = along_u ? patch.evaluate(from, across).x : patch.evaluate(across, from).x;
      const Vec3 b = along_u ? patch.evaluate(to, across).x : patch.evaluate(across, to).x;
      sum += (b - a).norm();
    }
  return sum / (lines + 1);
}

}  // namespace

std::vector<double> sheet_node_volumes(const Anatomy& sheet) {
  const std::vector<Vec3>& x = sheet.tets.positions;
  std::vector<double> out(x.size(), 0.0);
  for (const auto& q : sheet.quads) {
    const double a = ((x[q[0]] - x[q[3]]).norm() + (x[q[1]] - x[q[2]]).norm()) / 2;
    const double b = ((x[q[0]] - x[q[1]]).norm() + (x[q[3]] - x[q[2]]).norm()) / 2;
    for (const std::uint32_t node : q) out[node] += sheet.thickness * a * b / 4;
  }
  return out;
}

Anatomy make_sheet(const Vec3& size, double cell) {
  const std::uint32_t nx = pieces(size.x(), cell), nz = pieces(size.z(), cell);
  std::vector<Vec3> nodes;
  for (std::uint32_t k = 0; k <= nz; ++k)
    for (std::uint32_t i = 0; i <= nx; ++i)
      nodes.emplace_back(size.x() * (1.0 * i / nx - 0.5), 0, size.z() * (1.0 * k / nz - 0.5));
  return sheet_of(std::move(nodes), nx + 1, size.y());
}

Anatomy make_sheet(const Patch& patch, double thickness, double cell) {
  const std::uint32_t nu = pieces(mean_length(patch, true), cell),
                      nv = pieces(mean_length(patch, false), cell);
  std::vector<Vec3> nodes;
  for (std::uint32_t k = 0; k <= nv; ++k)
    for (std::uint32_t i = 0; i <= nu; ++i) nodes.push_back(patch.evaluate(1.0 * i / nu, 1.0 * k / nv).x);
  Anatomy out = sheet_of(std::move(nodes), nu + 1, thickness);
  for (const auto& q : out.quads)
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3 &a = out.tets.positions[q[k]], &b = out.tets.positions[q[(k + 1) % 4]];
      if ((b - a).norm() < 1e-3 * cell)
        throw InputError(
            fmt::format("patch: two nodes of the sheet coincide at ({:.4g}, {:.4g}, {:.4g}); a "
                        "sheet needs four sides with a length",
                        a.x(), a.y(), a.z()));
    }
  return out;
}

Anatomy make_rope(const Vec3& size, double cell) {
  const std::uint32_t n = pieces(size.x(), cell);
  std::vector<Vec3> nodes;
  for (std::uint32_t i = 0; i <= n; ++i) nodes.emplace_back(size.x() * (1.0 * i / n - 0.5), 0, 0);
  return rope_of(std::move(nodes), size.y());
}

Anatomy make_rope(const NurbsCurve& curve, double diameter, double cell) {
  return rope_of(equidistant_points(curve, cell), diameter);
}

}  // namespace prosector
