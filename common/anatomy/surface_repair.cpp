#include "common/anatomy/surface_repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <numeric>

#include "common/anatomy/coincident_points.h"
#include "common/anatomy/simplify.h"
#include "common/anatomy/surface_field.h"
#include "common/anatomy/winding_tree.h"

namespace prosector {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using Triangle = std::array<std::uint32_t, 3>;

/// Lists the triangles at each edge.
std::map<Edge, std::vector<std::uint32_t>> triangles_by_edge(const TriangleMesh& surface) {
  std::map<Edge, std::vector<std::uint32_t>> out;
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle& t = surface.triangles[i];
    for (std::size_t k = 0; k < 3; ++k)
      out[{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])}].push_back(i);
  }
  return out;
}

bool runs_along(const Triangle& t, const Edge& edge) {
  for (std::size_t k = 0; k < 3; ++k)
    if (t[k] == edge[0] && t[(k + 1) % 3] == edge[1]) return true;
  return false;
}

/// Disjoint sets of indices (union-find).
class Sets {
 public:
  explicit Sets(std::size_t count) {
    above_.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) above_.push_back(i);
  }
  std::uint32_t top(std::uint32_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { above_[top(a)] = top(b); }

 private:
  std::vector<std::uint32_t> above_;
};

void merge_rounded(RepairedSurface& out) {
  TriangleMesh merged = out.surface;
  const double tolerance = rounding_of_extent * extent_of(merged.positions);
  const std::vector<std::uint32_t> representative = coincident_points(merged.positions, tolerance);
  std::size_t moved = 0;
  for (std::uint32_t v = 0; v < representative.size(); ++v) moved += representative[v] != v ? 1 : 0;
  if (moved == 0) return;
  for (Triangle& t : merged.triangles)
    for (std::uint32_t& v : t) v = representative[v];
  drop_unused(merged);
  out.surface = std::move(merged);
  out.notes.push_back(fmt::format(
      "repaired: {} vertices within {:.2g} (rounding error, file units) of another vertex are merged with it",
      moved, tolerance));
}

/// Drops all but one of triangles with the same corners. Drops all of them if equally many face either side:
/// they are a wall inside a solid.
void drop_duplicates(RepairedSurface& out) {
  std::map<Triangle, std::vector<std::uint32_t>> by_corners;
  for (std::uint32_t i = 0; i < out.surface.triangles.size(); ++i) {
    Triangle key = out.surface.triangles[i];
    std::ranges::sort(key);
    by_corners[key].push_back(i);
  }
  std::vector<bool> drop(out.surface.triangles.size());
  std::size_t dropped = 0;
  for (const auto& [key, same] : by_corners) {
    if (same.size() < 2) continue;
    const auto along = std::ranges::count_if(same, [&, &edge = key](std::uint32_t i) {
      return runs_along(out.surface.triangles[i], {edge[0], edge[1]});
    });
    const bool forward = 2 * along > static_cast<std::ptrdiff_t>(same.size());
    bool keep = 2 * along != static_cast<std::ptrdiff_t>(same.size());
    for (const std::uint32_t i : same) {
      const bool stays = keep && runs_along(out.surface.triangles[i], {key[0], key[1]}) == forward;
      if (stays) keep = false;
      drop[i] = !stays;
      dropped += stays ? 0 : 1;
    }
  }
  if (dropped == 0) return;
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < drop.size(); ++i)
    if (!drop[i]) kept.push_back(out.surface.triangles[i]);
  out.surface.triangles = std::move(kept);
  drop_unused(out.surface);
  out.notes.push_back(fmt::format("repaired: {} repeated triangles are dropped", dropped));
}

/// Flips triangles so that neighbours are consistently oriented; in each connected patch, the minority is
/// flipped.
void orient_consistently(RepairedSurface& out) {
  std::vector<Triangle>& triangles = out.surface.triangles;
  const auto edges = triangles_by_edge(out.surface);
  std::vector<std::array<std::uint32_t, 2>> pairs;
  std::vector<std::vector<std::uint32_t>> pairs_of(triangles.size());
  std::vector<bool> unlike;
  for (const auto& [edge, around] : edges) {
    if (around.size() != 2) continue;
    for (const std::uint32_t t : around) pairs_of[t].push_back(static_cast<std::uint32_t>(pairs.size()));
    pairs.push_back({around[0], around[1]});
    unlike.push_back(runs_along(triangles[around[0]], edge) == runs_along(triangles[around[1]], edge));
  }
  std::vector<signed char> turn(triangles.size(), -1);  // −1: not visited
  std::size_t turned = 0;
  for (std::uint32_t first = 0; first < triangles.size(); ++first) {
    if (turn[first] >= 0) continue;
    std::vector<std::uint32_t> patch = {first};
    turn[first] = 0;
    std::size_t to_turn = 0;
    for (std::size_t at = 0; at < patch.size(); ++at)
      for (const std::uint32_t p : pairs_of[patch[at]]) {
        const std::uint32_t other = pairs[p][0] == patch[at] ? pairs[p][1] : pairs[p][0];
        if (turn[other] >= 0) continue;
        turn[other] = static_cast<signed char>(unlike[p] ? 1 - turn[patch[at]] : turn[patch[at]]);
        to_turn += turn[other] > 0 ? 1 : 0;
        patch.push_back(other);
      }
    const bool the_others = 2 * to_turn > patch.size();
    for (const std::uint32_t t : patch)
      if ((turn[t] > 0) != the_others) {
        std::swap(triangles[t][1], triangles[t][2]);
        ++turned;
      }
  }
  if (turned > 0)
    out.notes.push_back(
        fmt::format("repaired: {} triangles with inconsistent orientation are flipped", turned));
}

/// Shell of a surface: triangles connected through edges.
struct Shell {
  TriangleMesh mesh;
  double volume = 0;  // signed
  Eigen::AlignedBox3d box;
  std::unique_ptr<WindingTree> tree;  // built when first needed

  void turn() {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    volume = -volume;
    tree.reset();
  }
  double winding(const Vec3& x) {
    if (!tree) tree = std::make_unique<WindingTree>(mesh);
    return tree->at(x);
  }
};

/// Splits a surface into its shells, the largest first.
std::vector<Shell> split_shells(const TriangleMesh& surface, bool& manifold) {
  Sets sets(surface.triangles.size());
  Sets corners(3 * surface.triangles.size());  // corners of triangles, joined around a vertex through edges
  for (const auto& [edge, around] : triangles_by_edge(surface)) {
    manifold = manifold && around.size() == 2;
    for (const std::uint32_t t : around) {
      sets.join(t, around.front());
      for (const std::uint32_t v : edge) {
        const auto corner = [&, v = v](std::uint32_t i) {
          const Triangle& of = surface.triangles[i];
          return 3 * i + static_cast<std::uint32_t>(std::ranges::find(of, v) - of.begin());
        };
        corners.join(corner(t), corner(around.front()));
      }
    }
  }
  std::vector<std::uint32_t> fan(surface.positions.size(), UINT32_MAX);
  std::map<std::uint32_t, std::vector<std::uint32_t>> shells;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    shells[sets.top(t)].push_back(t);
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::uint32_t& first = fan[surface.triangles[t][k]];
      if (first == UINT32_MAX) first = corners.top(3 * t + k);
      manifold = manifold && first == corners.top(3 * t + k);
    }
  }
  std::vector<Shell> out;
  for (const auto& [top, triangles] : shells) {
    Shell& shell = out.emplace_back();
    shell.mesh.positions = shells.size() == 1 ? surface.positions : std::vector<Vec3>();
    std::map<std::uint32_t, std::uint32_t> number;
    for (const std::uint32_t t : triangles) {
      Triangle corner = surface.triangles[t];
      if (shells.size() > 1)
        for (std::uint32_t& v : corner) {
          const auto [it, fresh] =
              number.try_emplace(v, static_cast<std::uint32_t>(shell.mesh.positions.size()));
          if (fresh) shell.mesh.positions.push_back(surface.positions[v]);
          v = it->second;
        }
      shell.mesh.triangles.push_back(corner);
    }
    for (const Vec3& x : shell.mesh.positions) shell.box.extend(x);
    shell.volume = enclosed_volume(shell.mesh);
  }
  std::ranges::stable_sort(
      out, [](const Shell& a, const Shell& b) { return std::abs(a.volume) > std::abs(b.volume); });
  return out;
}

/// Returns whether the shell is inside the other, tested at some of its triangles; false if they cross.
bool is_inside_of(const Shell& shell, Shell& other) {
  if (!other.box.contains(shell.box)) return false;
  constexpr std::size_t asked = 8;
  const std::vector<Triangle>& triangles = shell.mesh.triangles;
  const std::size_t step = std::max<std::size_t>(1, triangles.size() / asked);
  for (std::size_t i = 0; i < triangles.size(); i += step) {
    const auto& x = shell.mesh.positions;
    const Vec3 middle = (x[triangles[i][0]] + x[triangles[i][1]] + x[triangles[i][2]]) / 3;
    if (std::abs(other.winding(middle)) < 0.75) return false;
  }
  return true;
}

/// A shell that is kept, and its solid.
struct KeptShell {
  Shell* shell;
  std::size_t solid;  // index in ShellsBySolid::volumes of the solid that the shell bounds or is a cavity of
  bool is_solid;
};

/// The kept shells of a surface, and how many of all shells were flipped, are cavities or were omitted.
struct ShellsBySolid {
  std::vector<KeptShell> kept;
  std::vector<double> volumes;  // of solids, without their cavities
  bool overlapping = false;     // some kept shells overlap, judged by their boxes
  std::size_t turned = 0, within = 0, cavities = 0;
  double within_volume = 0;  // of the omitted shells
};

/// How larger shells enclose a shell.
struct Enclosure {
  int depth = 0;           // solids less cavities around the shell
  std::size_t around = 0;  // the smallest solid around it, if any
  bool overlaps = false;   // a larger shell that doesn't enclose it overlaps it, judged by their boxes
};

Enclosure enclosure_of(const Shell& shell, const std::vector<KeptShell>& larger) {
  Enclosure out;
  for (const KeptShell& other : larger) {
    if (!is_inside_of(shell, *other.shell)) {
      out.overlaps = out.overlaps || (shell.box.intersection(other.shell->box).sizes().array() > 0).all();
      continue;
    }
    out.depth += other.is_solid ? 1 : -1;
    out.around = other.solid;  // the last one is the smallest
  }
  return out;
}

/// Assigns each shell to the solid that it bounds or is a cavity of; the shells must be in order of their
/// size, the largest first. Flips shells that face inward outside all solids, and omits shells that face
/// outward inside a solid.
ShellsBySolid by_solid(std::vector<Shell>& shells) {
  ShellsBySolid out;
  for (Shell& shell : shells) {
    const Enclosure enclosure = enclosure_of(shell, out.kept);
    if (shell.volume < 0 && enclosure.depth < 1) {
      shell.turn();
      ++out.turned;
    } else if (shell.volume >= 0 && enclosure.depth >= 1) {
      ++out.within;
      out.within_volume += shell.volume;
      continue;
    }
    out.overlapping = out.overlapping || enclosure.overlaps;
    const bool is_cavity = shell.volume < 0;
    if (!is_cavity) out.volumes.push_back(0);
    const std::size_t solid = is_cavity ? enclosure.around : out.volumes.size() - 1;
    out.volumes[solid] += shell.volume;
    out.cavities += is_cavity ? 1 : 0;
    out.kept.push_back({&shell, solid, !is_cavity});
  }
  return out;
}

/// Returns the notes for users on shells that were flipped, are cavities or were omitted; `total` is the
/// sum of the signed volumes of all shells.
std::vector<std::string> notes_on(const ShellsBySolid& sorted, double total) {
  std::vector<std::string> out;
  const auto shells_that = [](std::size_t count, const char* one, const char* several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
  };
  if (sorted.turned > 0)
    out.push_back("repaired: " + shells_that(sorted.turned, "shell facing inward is flipped",
                                             "shells facing inward are flipped"));
  if (sorted.cavities > 0)
    out.push_back(shells_that(sorted.cavities, "shell within another faces inward: a cavity",
                              "shells within others face inward: cavities"));
  if (sorted.within > 0)
    out.push_back(fmt::format(
        "warning: {} and enclose{} nothing: omitted. If a cavity is intended, flip the triangles "
        "inward ({:.2g} % of the volume)",
        shells_that(sorted.within, "shell is inside another and faces outward like it",
                    "shells are inside others and face outward like them"),
        sorted.within == 1 ? "s" : "", 100 * sorted.within_volume / std::max(std::abs(total), 1e-300)));
  return out;
}

}  // namespace

RepairedSurface repaired(TriangleMesh surface) {
  RepairedSurface out{std::move(surface), {}};
  if (surface_faults(out.surface)) merge_rounded(out);
  if (surface_faults(out.surface)) drop_duplicates(out);
  if (surface_faults(out.surface).opposed_edges > 0) orient_consistently(out);
  return out;
}

SolidShells solid_shells(const TriangleMesh& closed) {
  SolidShells out;
  bool manifold = true;
  std::vector<Shell> shells = split_shells(closed, manifold);
  out.simple = manifold && shells.size() == 1;
  double total = 0;
  for (const Shell& shell : shells) total += shell.volume;
  if (total < 0)
    for (Shell& shell : shells) shell.turn();
  ShellsBySolid sorted = by_solid(shells);
  out.overlapping = sorted.overlapping;
  if (sorted.kept.size() == 1 && shells.size() == 1) {
    out.surface = std::move(shells.front().mesh);
  } else {
    for (const KeptShell& kept : sorted.kept) append(out.surface, kept.shell->mesh);
  }
  out.notes = notes_on(sorted, total);
  out.solids = std::move(sorted.volumes);
  std::ranges::sort(out.solids, std::greater<>());
  return out;
}

}  // namespace prosector
