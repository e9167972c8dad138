#include "common/anatomy/isosurface.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "common/anatomy/bcc_lattice.h"
#include "common/anatomy/simplify.h"
#include "common/anatomy/surface_check.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr double max_surface_lattice = 1 << 24;  // points: 128 MB of values, a few seconds

TriangleMesh march(const SolidField& field, double cell) {
  const BccLattice lattice(field, cell, Vec3::Zero(), max_surface_lattice);
  std::vector<double> value(lattice.size());
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = field.value(lattice.position(i));

  TriangleMesh mesh;
  std::unordered_map<std::uint64_t, std::uint32_t> cuts;
  const auto cut = [&](std::size_t in, std::size_t out) {
    const auto key = (static_cast<std::uint64_t>(in) << 32) | out;
    const auto [it, fresh] = cuts.try_emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
    if (fresh) {
      const Vec3 a = lattice.position(in), b = lattice.position(out);
      // Kept off the ends, so that no two cut points coincide.
      const double t = std::clamp(crossing(field, a, value[in], b, value[out]), 0.02, 0.98);
      mesh.positions.push_back(a + t * (b - a));
    }
    return it->second;
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vec3& outward) {
    const auto& x = mesh.positions;
    if ((x[b] - x[a]).cross(x[c] - x[a]).dot(outward) < 0) std::swap(b, c);
    mesh.triangles.push_back({a, b, c});
  };
  lattice.for_tets([&](const std::array<std::size_t, 4>& tet) {
    std::array<std::size_t, 4> in{}, out{};
    std::size_t ins = 0, outs = 0;
    Vec3 outward = Vec3::Zero();
    for (const std::size_t v : tet) (value[v] < 0 ? in[ins++] : out[outs++]) = v;
    if (ins == 0 || outs == 0) return;
    for (std::size_t k = 0; k < outs; ++k) outward += lattice.position(out[k]) / static_cast<double>(outs);
    for (std::size_t k = 0; k < ins; ++k) outward -= lattice.position(in[k]) / static_cast<double>(ins);
    if (ins == 1) {
      add(cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2]), outward);
    } else if (outs == 1) {
      add(cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0]), outward);
    } else {
      const auto a = cut(in[0], out[0]), b = cut(in[0], out[1]), c = cut(in[1], out[1]),
                 d = cut(in[1], out[0]);
      add(a, b, c, outward);
      add(a, c, d, outward);
    }
  });
  return mesh;
}

// Projects a nearby point onto the zero set by bounded Newton steps along the gradient; if they fail, returns
// it unchanged.
Vec3 project(const SolidField& field, const Vec3& start, double cell) {
  Vec3 x = start;
  double f = field.value(x);
  for (int k = 0; k < 4; ++k) {
    const Vec3 g = gradient(field, x, 0.1 * cell);
    if (g.squaredNorm() < 1e-20) break;
    Vec3 step = -f * g / g.squaredNorm();
    const double limit = 0.2 * cell;
    if (step.norm() > limit) step *= limit / step.norm();
    const double next = field.value(x + step);
    if (!(std::abs(next) < std::abs(f))) break;
    x += step;
    f = next;
  }
  return (x - start).norm() < 0.5 * cell ? x : start;
}

// Moves vertices towards the mean of their neighbours, then back onto the surface.
void relax(TriangleMesh& mesh, const SolidField& field, double cell) {
  constexpr int rounds = 4;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Vec3> sum(mesh.positions.size(), Vec3::Zero()), normal = sum;
    std::vector<double> count(mesh.positions.size());
    for (const auto& t : mesh.triangles) {
      const auto& x = mesh.positions;
      const Vec3 n = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
      for (std::size_t k = 0; k < 3; ++k) {
        sum[t[k]] += x[t[(k + 1) % 3]];
        count[t[k]] += 1;
        normal[t[k]] += n;
      }
    }
    for (std::size_t v = 0; v < sum.size(); ++v) {
      Vec3 move = 0.5 * (sum[v] / count[v] - mesh.positions[v]);
      const Vec3 n = normal[v].normalized();
      move -= n * n.dot(move);
      mesh.positions[v] = project(field, mesh.positions[v] + move, cell);
    }
  }
}

// Resolves crossing triangles, as in creases: moves their vertices to the mean of their neighbours.
void untangle(TriangleMesh& mesh) {
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    const auto pairs = intersecting_triangles(mesh);
    if (pairs.empty()) return;
    std::vector<bool> moves(mesh.positions.size());
    for (const auto& pair : pairs)
      for (const auto t : pair)
        for (const auto v : mesh.triangles[t]) moves[v] = true;
    std::vector<Vec3> sum(mesh.positions.size(), Vec3::Zero());
    std::vector<double> count(mesh.positions.size());
    for (const auto& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        sum[t[k]] += mesh.positions[t[(k + 1) % 3]];
        count[t[k]] += 1;
      }
    for (std::size_t v = 0; v < moves.size(); ++v)
      if (moves[v]) mesh.positions[v] = sum[v] / count[v];
  }
}

}  // namespace

TriangleMesh largest_piece(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> root(mesh.positions.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](std::uint32_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 2; ++k) root[find(t[k])] = find(t[k + 1]);
  std::vector<double> volume(mesh.positions.size());
  for (const auto& t : mesh.triangles)
    volume[find(t[0])] += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]]));
  const auto best =
      static_cast<std::uint32_t>(std::max_element(volume.begin(), volume.end()) - volume.begin());
  TriangleMesh out = mesh;
  std::erase_if(out.triangles, [&](const auto& t) { return find(t[0]) != best; });
  drop_unused(out);
  return out;
}

TriangleMesh isosurface(const SolidField& field, double cell) {
  TriangleMesh mesh = march(field, cell);
  if (mesh.triangles.empty())
    throw InputError(
        fmt::format("surface: it has no triangles at a surface cell of {:.3g} mm; allowed: surface_cell "
                    "below the thickness of the shape's thinnest part",
                    1000 * cell));
  mesh = simplify(largest_piece(mesh), cell, [&](const Vec3& x) { return project(field, x, cell); });
  relax(mesh, field, cell);
  untangle(mesh);
  return mesh;
}

}  // namespace prosector
