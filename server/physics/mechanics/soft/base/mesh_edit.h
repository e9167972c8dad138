#pragma once
// Edit of a tetrahedral mesh in which most entries stay, in their order. Data that depend on the mesh can be
// updated instead of rebuilt.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "common/math.h"
#include "common/mesh.h"

namespace prosector {

/// Entries of a list that an edit keeps, and their new indices.
struct Kept {
  /// Entries from index `from` on before the edit, which are at `to` on now.
  struct Run {
    std::uint32_t from = 0, to = 0, count = 0;
  };
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<Run> runs;  // ascending in both indices
  std::size_t before = 0, now = 0;

  /// Returns an edit that keeps all entries: the first `before` of `now` are the old ones.
  static Kept all(std::size_t before, std::size_t now);
  /// Adds a kept entry that moves from index `from` to index `to`. Calls must be ascending.
  void add(std::uint32_t from, std::uint32_t to);

  /// Returns how many of the first entries keep their index.
  std::size_t unmoved() const;
  bool all_unmoved() const { return unmoved() == before; }
  std::vector<std::uint32_t> destinations() const;  // by index before: the index now, or none
  std::vector<std::uint32_t> origins() const;       // by index now: the index before, or none

  /// Moves `values`, with `each` values per entry, to the present indices; values of new entries are
  /// undefined.
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
  /// Edge nodes of quadratic elements (edge_nodes.h): six of each of these tetrahedra, on the edges between
  /// its corners in ascending order.
  std::vector<std::uint32_t> middles;
  /// Corners of these tetrahedra, now and before the edit, and of removed ones; ascending.
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

}  // namespace prosector
