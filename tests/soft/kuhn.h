#pragma once
// Boxes of tetrahedra: each cell in six, one for each order of the axes (Kuhn 1960).

#include <algorithm>
#include <array>
#include <cstdint>

#include "common/mesh.h"

namespace prosector {

/// Nodes are numbered x fastest; `cells` per axis over a box from the origin to `size`.
inline TetMesh kuhn_box(std::array<std::uint32_t, 3> cells, const Vec3& size) {
  TetMesh mesh;
  const auto node = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return (k * (cells[1] + 1) + j) * (cells[0] + 1) + i;
  };
  for (std::uint32_t k = 0; k <= cells[2]; ++k) {
    for (std::uint32_t j = 0; j <= cells[1]; ++j) {
      for (std::uint32_t i = 0; i <= cells[0]; ++i) {
        mesh.positions.emplace_back(size[0] * i / cells[0], size[1] * j / cells[1], size[2] * k / cells[2]);
      }
    }
  }
  for (std::uint32_t k = 0; k < cells[2]; ++k) {
    for (std::uint32_t j = 0; j < cells[1]; ++j) {
      for (std::uint32_t i = 0; i < cells[0]; ++i) {
        std::array<std::size_t, 3> axes = {0, 1, 2};
        bool even = true;
        do {
          std::array<std::uint32_t, 3> at = {i, j, k};
          std::array<std::uint32_t, 4> tet{node(i, j, k)};
          for (std::size_t a = 0; a < 3; ++a) {
            ++at[axes[a]];
            tet[a + 1] = node(at[0], at[1], at[2]);
          }
          even = (axes[0] < axes[1]) ^ (axes[1] < axes[2]) ^ (axes[0] < axes[2]);
          if (!even) std::swap(tet[2], tet[3]);
          mesh.tets.push_back(tet);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
    }
  }
  return mesh;
}

/// A body of those tetrahedra with no surface to touch.
inline Anatomy kuhn_anatomy(std::array<std::uint32_t, 3> cells, const Vec3& size) {
  return {kuhn_box(cells, size), {}, {}};
}

/// Displaces interior nodes at random (x ± amplitude), boundary nodes stay.
template <class Random>
void jitter_interior(TetMesh& mesh, const Vec3& size, double amplitude, Random& random) {
  for (Vec3& x : mesh.positions) {
    const bool inside = (x.array() > 1e-9).all() && (x.array() < size.array() - 1e-9).all();
    if (inside) {
      for (int c = 0; c < 3; ++c) x[c] += amplitude * random();
    }
  }
}

}  // namespace prosector
