#include "common/anatomy/tet_repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "common/anatomy/coincident_points.h"
#include "common/anatomy/mesh_quality.h"
#include "common/error.h"

namespace prosector {
namespace {

using Tet = std::array<std::uint32_t, 4>;
using Face = std::array<std::uint32_t, 3>;

double volume_of(const TetMesh& mesh, const Tet& t) {
  const auto& x = mesh.positions;
  return tet_volume(x[t[0]], x[t[1]], x[t[2]], x[t[3]]);
}

/// Returns the three nodes other than that of local index `node`, sorted.
Face face_without(const Tet& tet, std::size_t node) {
  Face out{};
  for (std::size_t k = 0, n = 0; k < 4; ++k)
    if (k != node) out[n++] = tet[k];
  std::ranges::sort(out);
  return out;
}

void say(const Progress& report, const std::string& line) {
  if (report) report(line);
}

/// Drops tetrahedra with the same nodes as an earlier one.
void drop_duplicates(TetMesh& mesh, const Progress& report) {
  std::vector<std::pair<Tet, std::uint32_t>> keys;
  keys.reserve(mesh.tets.size());
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t) {
    Tet key = mesh.tets[t];
    std::ranges::sort(key);
    keys.push_back({key, t});
  }
  std::ranges::sort(keys);
  std::vector<bool> keep(keys.size(), true);
  std::size_t dropped = 0;
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (keys[i].first == keys[i - 1].first) {
      keep[keys[i].second] = false;
      ++dropped;
    }
  if (dropped == 0) return;
  mesh = subset(mesh, keep);
  say(report, fmt::format("repaired: {} duplicate tetrahedra are dropped", dropped));
}

void turn_and_drop_flat(TetMesh& mesh, const Progress& report) {
  std::vector<bool> keep;
  for (Tet& t : mesh.tets) {
    const auto& x = mesh.positions;
    const double volume = volume_of(mesh, t);
    if (volume < 0) std::swap(t[2], t[3]);
    double longest = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, (x[t[i]] - x[t[j]]).norm());
    constexpr double flat = 1e-6;  // 6V over the longest edge's cube: no stress can be computed below
    keep.push_back(std::abs(volume) > flat * longest * longest * longest);
  }
  const auto dropped = std::ranges::count(keep, false);
  mesh = subset(mesh, keep);
  if (dropped > 0) say(report, fmt::format("repaired: {} flat tetrahedra are dropped", dropped));
}

std::size_t pieces(const TetMesh& mesh) {
  const std::vector<std::uint32_t> components = tet_components(mesh);
  return components.empty() ? 0 : 1 + *std::ranges::max_element(components);
}

/// Merges coincident nodes if that connects pieces. A slit within one piece remains.
void merge_coincident_nodes(TetMesh& mesh, const Progress& report) {
  const std::size_t before = pieces(mesh);
  if (before < 2) return;
  TetMesh merged = mesh;
  const auto representative =
      coincident_points(mesh.positions, rounding_of_extent * extent_of(mesh.positions));
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < representative.size(); ++v) count += representative[v] != v ? 1 : 0;
  for (Tet& t : merged.tets)
    for (std::uint32_t& v : t) v = representative[v];
  const std::size_t after = count == 0 ? before : pieces(merged);
  if (after < before) {
    mesh = subset(merged, std::vector<bool>(merged.tets.size(), true));
    say(report, fmt::format("repaired: {} nodes are merged with another node at the same position, which "
                            "joins {} pieces to {}",
                            count, before, after));
  }
  if (after > 1)
    say(report, fmt::format("warning: its tetrahedra form {} pieces without common faces, which will move "
                            "apart; join them in a mesh editor",
                            after));
}

/// A face (sorted nodes) and a tetrahedron that has it.
struct FaceOfTet {
  Face face;
  std::uint32_t tet;
  auto operator<=>(const FaceOfTet&) const = default;
};

std::vector<FaceOfTet> sorted_faces(const TetMesh& mesh) {
  std::vector<FaceOfTet> out;
  out.reserve(4 * mesh.tets.size());
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t)
    for (std::size_t without = 0; without < 4; ++without)
      out.push_back({face_without(mesh.tets[t], without), t});
  std::ranges::sort(out);
  return out;
}

/// Calls visit(first, count) for each run of equal faces.
template <class Visit>
void for_faces(const std::vector<FaceOfTet>& faces, Visit&& visit) {
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t end = i + 1;
    while (end < faces.size() && faces[end].face == faces[i].face) ++end;
    visit(&faces[i], end - i);
    i = end;
  }
}

/// Counts quadrilaterals split along different diagonals by the cells on both sides. These are four boundary
/// faces of the same four nodes, not all of one tetrahedron.
std::size_t mismatched_face_splits(const std::map<Face, std::uint32_t>& border) {
  std::map<std::array<std::uint32_t, 2>, std::vector<Face>> by_edge;
  for (const auto& [face, tet] : border)
    for (std::size_t k = 0; k < 3; ++k)
      by_edge[{std::min(face[k], face[(k + 1) % 3]), std::max(face[k], face[(k + 1) % 3])}].push_back(face);
  const auto fits = [&](const Tet& nodes) {
    std::set<std::uint32_t> tets;
    for (std::size_t without = 0; without < 4; ++without) {
      const auto it = border.find(face_without(nodes, without));
      if (it == border.end()) return true;
      tets.insert(it->second);
    }
    return tets.size() == 1;
  };
  std::set<Tet> unlike;
  for (const auto& [edge, around] : by_edge)
    for (std::size_t i = 0; i < around.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        std::set<std::uint32_t> nodes(around[i].begin(), around[i].end());
        nodes.insert(around[j].begin(), around[j].end());
        Tet four{};
        if (nodes.size() != four.size()) continue;
        std::ranges::copy(nodes, four.begin());
        if (!fits(four)) unlike.insert(four);
      }
  return unlike.size();
}

void refuse_misfits(const TetMesh& mesh, const std::string& name) {
  std::size_t crowded = 0;
  std::map<Face, std::uint32_t> border;
  for_faces(sorted_faces(mesh), [&](const FaceOfTet* faces, std::size_t count) {
    crowded += count > 2 ? 1 : 0;
    if (count == 1) border.emplace_hint(border.end(), faces->face, faces->tet);
  });
  if (crowded > 0)
    throw InputError(
        fmt::format("{}: {} faces belong to more than two tetrahedra: elements overlap. Remove the "
                    "duplicates, or mesh it again",
                    name, crowded));
  if (const std::size_t unlike = mismatched_face_splits(border); unlike > 0)
    throw InputError(fmt::format(
        "{}: at {} quadrilateral faces the cells on both sides do not match: tetrahedra meet hexahedra, "
        "prisms or pyramids along another diagonal. Save the mesh with tetrahedra only",
        name, unlike));
}

}  // namespace

TetMesh repaired(TetMesh mesh, const std::string& name, const Progress& report) {
  drop_duplicates(mesh, report);
  turn_and_drop_flat(mesh, report);
  if (mesh.tets.empty())
    throw InputError(
        fmt::format("{}: the mesh has no tetrahedra; at least one that is not flat is needed", name));
  merge_coincident_nodes(mesh, report);
  drop_duplicates(mesh, report);
  refuse_misfits(mesh, name);
  return mesh;
}

TetOverlap find_tet_overlap(const TetMesh& mesh) {
  struct Neighbour {
    std::uint32_t tet;
    bool same_side;
  };
  std::vector<std::vector<Neighbour>> neighbours(mesh.tets.size());
  const auto side = [&](std::uint32_t tet, const Face& face) {
    const Tet& t = mesh.tets[tet];
    const auto& x = mesh.positions;
    const auto apex =
        *std::ranges::find_if(t, [&](std::uint32_t v) { return std::ranges::find(face, v) == face.end(); });
    return tet_volume(x[face[0]], x[face[1]], x[face[2]], x[apex]) > 0;
  };
  for_faces(sorted_faces(mesh), [&](const FaceOfTet* faces, std::size_t count) {
    if (count != 2) return;
    const bool same = side(faces[0].tet, faces->face) == side(faces[1].tet, faces->face);
    neighbours[faces[0].tet].push_back({faces[1].tet, same});
    neighbours[faces[1].tet].push_back({faces[0].tet, same});
  });
  // Unfolds each piece as if no face were folded over; tetrahedra that are then mirrored overlap others.
  TetOverlap out;
  std::vector<signed char> mirrored(mesh.tets.size(), -1);  // −1: not visited
  for (std::uint32_t first = 0; first < mesh.tets.size(); ++first) {
    if (mirrored[first] >= 0) continue;
    std::vector<std::uint32_t> piece = {first};
    mirrored[first] = 0;
    double volume = 0;
    std::size_t count = 0;
    for (std::size_t at = 0; at < piece.size(); ++at) {
      const std::uint32_t t = piece[at];
      volume += (mirrored[t] > 0 ? -1 : 1) * std::abs(volume_of(mesh, mesh.tets[t]));
      count += mirrored[t] > 0 ? 1 : 0;
      for (const Neighbour& n : neighbours[t]) {
        if (mirrored[n.tet] >= 0) continue;
        mirrored[n.tet] = static_cast<signed char>(n.same_side ? 1 - mirrored[t] : mirrored[t]);
        piece.push_back(n.tet);
      }
    }
    out.tets += std::min(count, piece.size() - count);
    out.enclosed += std::abs(volume);
  }
  return out;
}

}  // namespace prosector
