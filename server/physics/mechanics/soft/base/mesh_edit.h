#pragma once
// Edit of a tetrahedral mesh in which most entries stay, in their order. Data that depend on the mesh can be
// updated instead of rebuilt.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "common/math.h"
#include "common/mesh.h"

namespace prosector::soft {

/// Entries of a list, such as nodes or tetrahedra, that an edit preserves, with their indices before and
/// after it. They keep their order.
struct Kept {
  /// Run of `count` consecutive entries that an edit preserves. The first has index `from` before the edit
  /// and index `to` after it.
  struct Run {
    std::uint32_t from = 0, to = 0, count = 0;
  };
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<Run> runs;  // ascending in both indices
  std::size_t before = 0, now = 0;

  /// Returns the record of an edit that preserves all `before` entries at their indices and appends new ones,
  /// so that there are `now` entries after it.
  static Kept all(std::size_t before, std::size_t now);
  /// Records that the entry with index `from` before the edit has index `to` after it. Calls must be in
  /// ascending order of both.
  void add(std::uint32_t from, std::uint32_t to);

  /// Returns how many entries at the beginning of the list the edit preserves at the same index.
  std::size_t unmoved() const;
  bool all_unmoved() const { return unmoved() == before; }
  std::vector<std::uint32_t> destinations() const;  // by index before: the index now, or none
  std::vector<std::uint32_t> origins() const;       // by index now: the index before, or none

  /// Moves data of a list's preserved entries to the indices after the edit, and resizes `values`. `each`:
  /// number of values per entry. The values of new entries are undefined.
  template <class T>
  void carry(std::vector<T>& values, std::size_t each = 1) const;
  void carry(VecX& values) const;
};

struct MeshEdit {
  using Corners = std::array<std::uint32_t, 4>;

  // All indices are present indices of nodes and tetrahedra.
  Kept kept_nodes, kept_tets;
  std::vector<std::uint32_t> made_nodes;  // new nodes; ascending
  std::vector<Vec3> positions;            // m, rest positions of the new nodes
  std::vector<std::uint32_t> tets;        // new tetrahedra, and those whose corners changed; ascending
  std::vector<Corners> corners;           // of these tetrahedra
  /// Indices of the edge nodes of the new and changed tetrahedra, for quadratic elements only. There are six
  /// for each tetrahedron, on the edges between its corners in ascending order (edge_nodes.h).
  std::vector<std::uint32_t> middles;
  /// Nodes at which elements changed: the corners, before and after the edit, of new, changed and removed
  /// tetrahedra. Given by their present indices, ascending.
  std::vector<std::uint32_t> nodes;
};

void apply(const MeshEdit& edit, TetMesh& mesh);

template <class T>
void Kept::carry(std::vector<T>& values, std::size_t each) const {
  const auto at = [each](auto& list, std::size_t entry) {
    return list.begin() + static_cast<std::ptrdiff_t>(each * entry);
  };
  const bool all_down = std::all_of(runs.begin(), runs.end(), [](const Run& r) { return r.to <= r.from; });
  if (all_down) {
    for (const Run& run : runs)
      if (run.to < run.from)
        std::copy(at(values, run.from), at(values, run.from + run.count), at(values, run.to));
    values.resize(each * now);
    return;
  }
  std::vector<T> out(each * now);
  for (const Run& run : runs)
    std::copy(at(values, run.from), at(values, run.from + run.count), at(out, run.to));
  values = std::move(out);
}

}  // namespace prosector::soft
