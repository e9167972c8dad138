#pragma once
// What became of a mesh of tetrahedra most of which stay as they are, in their order. So what hangs on the
// mesh can follow instead of being made anew.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "common/math.h"
#include "common/mesh.h"

namespace prosector {

/// Which entries of a list are entries of what became of it, and where.
struct Kept {
  /// Those from `from` on are those from `to` on now.
  struct Run {
    std::uint32_t from = 0, to = 0, count = 0;
  };
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<Run> runs;  // ascending in both
  std::size_t before = 0, now = 0;

  /// Returns what keeps all: the first `before` of `now` are those that were there.
  static Kept all(std::size_t before, std::size_t now);
  /// Adds one that is moved `from` before `to` now, after those added so far.
  void add(std::uint32_t from, std::uint32_t to);

  /// Returns how many, from the first on, are where they were.
  std::size_t unmoved() const;
  bool all_unmoved() const { return unmoved() == before; }
  std::vector<std::uint32_t> destinations() const;  // by index before: now, or none
  std::vector<std::uint32_t> origins() const;       // by index now: before, or none

  /// Carries `values`, `each` an entry, to what they are now; of what is new they are anything.
  template <class T>
  void carry(std::vector<T>& values, std::size_t each = 1) const;
  void carry(VecX& values) const;
};

struct MeshEdit {
  using Corners = std::array<std::uint32_t, 4>;

  // All indices are those that nodes and tetrahedra have now.
  Kept kept_nodes, kept_tets;
  std::vector<std::uint32_t> made_nodes;  // new ones; ascending
  std::vector<Vec3> positions;            // m, at rest: of them
  std::vector<std::uint32_t> tets;        // new ones, and those whose corners are others; ascending
  std::vector<Corners> corners;           // of them
  /// Middles of quadratic elements (edge_nodes.h): six of each, on the edges between its corners, these in
  /// ascending order.
  std::vector<std::uint32_t> middles;
  std::vector<std::uint32_t> nodes;  // corners of these, of what these were and of what is gone; ascending
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
