#include "common/curves/patch_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double min_parameter_step = 1e-6;  // of a parameter: finer steps are not subdivided

/// Returns the largest distance of the patch from the straight line between two of its points, sampled at a
/// quarter, half and three quarters of the parameter step.
double sag(const Patch& patch, double u0, double v0, double u1, double v1) {
  const Vec3 a = patch.evaluate(u0, v0).x, b = patch.evaluate(u1, v1).x;
  double worst = 0;
  for (const double s : {0.25, 0.5, 0.75}) {
    const Vec3 x = patch.evaluate(u0 + s * (u1 - u0), v0 + s * (v1 - v0)).x;
    const Vec3 along = b - a;
    const double share = along.squaredNorm() > 0 ? along.dot(x - a) / along.squaredNorm() : 0;
    worst = std::max(worst, (x - a - std::clamp(share, 0.0, 1.0) * along).norm());
  }
  return worst;
}

/// Returns the largest height of the patch above the diagonal shared by two triangles. Measured along the
/// patch's normal, because a tangential offset isn't an error: the triangles may be elsewhere in the surface.
double diagonal_deviation(const Patch& patch, double u0, double v0, double u1, double v1) {
  const Vec3 a = patch.evaluate(u0, v0).x, b = patch.evaluate(u1, v1).x;
  double worst = 0;
  for (const double s : {0.25, 0.5, 0.75}) {
    const PatchPoint p = patch.evaluate(u0 + s * (u1 - u0), v0 + s * (v1 - v0));
    const Vec3 normal = p.u.cross(p.v);
    if (normal.norm() > 0) worst = std::max(worst, std::abs(normal.normalized().dot(p.x - a - s * (b - a))));
  }
  return worst;
}

/// Inserts a line halfway between two neighbouring `lines` if `is_coarse` is true for them. Returns whether
/// any was inserted.
template <class IsCoarse>
bool halve(std::vector<double>& lines, const IsCoarse& is_coarse) {
  std::vector<double> out = {lines.front()};
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    if (lines[k + 1] - lines[k] > min_parameter_step && is_coarse(lines[k], lines[k + 1]))
      out.push_back((lines[k] + lines[k + 1]) / 2);
    out.push_back(lines[k + 1]);
  }
  const bool changed = out.size() > lines.size();
  lines = std::move(out);
  return changed;
}

/// Returns the lines with a line halfway between each two neighbours.
std::vector<double> with_middles(const std::vector<double>& lines) {
  std::vector<double> out;
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    out.push_back(lines[k]);
    out.push_back((lines[k] + lines[k + 1]) / 2);
  }
  out.push_back(lines.back());
  return out;
}

void check_size(const PatchGrid& grid, double tolerance) {
  if (grid.u.size() * grid.v.size() > max_grid_points)
    throw InputError(
        fmt::format("a patch needs {} × {} points for a tolerance of {} m; increase the tolerance",
                    grid.u.size(), grid.v.size(), tolerance));
}

/// A patch sampled at its grid's points, u fastest, with unit normals.
struct SampledPatch {
  std::uint32_t nu, nv;
  std::vector<Vec3> places, normals;
};

SampledPatch sample(const Patch& patch, const PatchGrid& grid) {
  SampledPatch out{
      static_cast<std::uint32_t>(grid.u.size()), static_cast<std::uint32_t>(grid.v.size()), {}, {}};
  std::vector<PatchPoint> points;
  double largest = 0;
  for (const double v : grid.v)
    for (const double u : grid.u) {
      points.push_back(patch.evaluate(u, v));
      out.places.push_back(points.back().x);
      out.normals.push_back(points.back().u.cross(points.back().v));
      largest = std::max(largest, out.normals.back().norm());
    }
  if (!(largest > 0)) throw InputError("a patch without area");
  // At a pole one derivative is zero: use the mean normal of the adjacent grid line instead.
  const std::vector<Vec3> own = out.normals;
  for (std::uint32_t j = 0; j < out.nv; ++j)
    for (std::uint32_t i = 0; i < out.nu; ++i) {
      Vec3& normal = out.normals[j * out.nu + i];
      const PatchPoint& p = points[j * out.nu + i];
      if (normal.norm() <= 1e-9 * largest) {
        normal.setZero();
        // The last point of a closed line equals its first.
        if (p.u.norm() <= p.v.norm())
          for (std::uint32_t k = 0; k + 1 < out.nu; ++k) normal += own[(j > 0 ? j - 1 : j + 1) * out.nu + k];
        else
          for (std::uint32_t k = 0; k + 1 < out.nv; ++k) normal += own[k * out.nu + (i > 0 ? i - 1 : i + 1)];
      }
      normal.normalize();
    }
  return out;
}

/// Returns whether the first and the last grid line across u (or v) coincide and the surface is smooth there.
bool is_closed_along(const SampledPatch& p, bool along_u) {
  double extent = 0;
  for (const Vec3& x : p.places) extent = std::max(extent, (x - p.places.front()).norm());
  const std::uint32_t count = along_u ? p.nv : p.nu;
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::size_t first = along_u ? std::size_t{k} * p.nu : k;
    const std::size_t last = along_u ? first + p.nu - 1 : first + std::size_t{p.nv - 1} * p.nu;
    if ((p.places[last] - p.places[first]).norm() > 1e-9 * extent) return false;
    if (p.normals[last].dot(p.normals[first]) < 1 - 1e-6) return false;
  }
  return true;
}

/// Merges vertices at equal positions, and drops triangles that degenerate to edges.
void weld_poles(TriangleMesh& mesh) {
  struct Before {
    bool operator()(const Vec3& a, const Vec3& b) const {
      return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    }
  };
  double extent = 0;
  for (const Vec3& x : mesh.positions) extent = std::max(extent, (x - mesh.positions.front()).norm());
  std::map<Vec3, std::uint32_t, Before> index;
  std::vector<std::uint32_t> new_index;
  std::vector<Vec3> kept;
  for (const Vec3& x : mesh.positions) {
    const Vec3 rounded = (x / (1e-9 * extent)).array().round();
    const auto [found, is_new] = index.emplace(rounded, static_cast<std::uint32_t>(kept.size()));
    if (is_new) kept.push_back(x);
    new_index.push_back(found->second);
  }
  mesh.positions = std::move(kept);
  for (auto& t : mesh.triangles) t = {new_index[t[0]], new_index[t[1]], new_index[t[2]]};
  std::erase_if(mesh.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

}  // namespace

// The error of a cell's triangles has two parts: the sag of the cell's sides, and the height over the
// diagonal.
PatchGrid refine_grid(const Patch& patch, double tolerance) {
  auto [u, v] = patch.seams();
  PatchGrid grid{std::move(u), std::move(v)};
  for (bool changed = true; changed;) {
    const std::vector<double> along_v = with_middles(grid.v), along_u = with_middles(grid.u);
    changed = halve(grid.u, [&](double a, double b) {
      return std::ranges::any_of(along_v,
                                 [&](double at) { return sag(patch, a, at, b, at) > tolerance / 2; });
    });
    changed |= halve(grid.v, [&](double a, double b) {
      return std::ranges::any_of(along_u,
                                 [&](double at) { return sag(patch, at, a, at, b) > tolerance / 2; });
    });
    check_size(grid, tolerance);
    if (changed) continue;
    // The remaining error is the twist of the cells.
    const PatchGrid fitted = grid;
    std::set<double> coarse_v;  // start of the intervals to halve
    changed = halve(grid.u, [&](double a, double b) {
      bool any = false;
      for (std::size_t k = 0; k + 1 < fitted.v.size(); ++k) {
        if (diagonal_deviation(patch, a, fitted.v[k], b, fitted.v[k + 1]) <= tolerance) continue;
        coarse_v.insert(fitted.v[k]);
        any = true;
      }
      return any;
    });
    halve(grid.v, [&](double a, double) { return coarse_v.contains(a); });
    check_size(grid, tolerance);
  }
  return grid;
}

TriangleMesh slab_mesh(const Patch& patch, double thickness, double tolerance) {
  // Where the patch bends, one face of the slab is larger than the patch, and its triangles deviate more.
  const PatchGrid grid = refine_grid(patch, tolerance / 2);
  const SampledPatch sampled = sample(patch, grid);
  const auto& [nu, nv, places, normals] = sampled;
  const bool ring_u = is_closed_along(sampled, true), ring_v = is_closed_along(sampled, false);
  const std::uint32_t wu = ring_u ? nu - 1 : nu, wv = ring_v ? nv - 1 : nv;
  const auto at = [wu, wv](std::uint32_t i, std::uint32_t j) { return j % wv * wu + i % wu; };
  TriangleMesh out;
  for (const double side : {0.5, -0.5})
    for (std::uint32_t j = 0; j < wv; ++j)
      for (std::uint32_t i = 0; i < wu; ++i)
        out.positions.push_back(places[j * nu + i] + side * thickness * normals[j * nu + i]);
  const std::uint32_t below = wu * wv;
  const auto add_quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    out.triangles.push_back({a, b, c});
    out.triangles.push_back({a, c, d});
  };
  for (std::uint32_t j = 0; j + 1 < nv; ++j)
    for (std::uint32_t i = 0; i + 1 < nu; ++i) {
      const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      add_quad(a, b, c, d);
      // The same diagonal, with the opposite orientation.
      out.triangles.push_back({below + a, below + c, below + b});
      out.triangles.push_back({below + a, below + d, below + c});
    }
  const auto add_rim = [&](std::uint32_t from, std::uint32_t to) {
    add_quad(from, from + below, to + below, to);
  };
  for (std::uint32_t i = 0; i + 1 < nu && !ring_v; ++i) {
    add_rim(at(i, 0), at(i + 1, 0));
    add_rim(at(i + 1, nv - 1), at(i, nv - 1));
  }
  for (std::uint32_t j = 0; j + 1 < nv && !ring_u; ++j) {
    add_rim(at(nu - 1, j), at(nu - 1, j + 1));
    add_rim(at(0, j + 1), at(0, j));
  }
  weld_poles(out);
  return out;
}

}  // namespace prosector
