#pragma once
// Changes of a surface's vertex and triangle lists by a cut.

#include <array>
#include <cstdint>
#include <vector>

#include "common/assert.h"
#include "common/mesh.h"
#include "server/physics/base/list_edit.h"
#include "server/physics/base/topology.h"

namespace prosector {

/// Change of a surface mesh by a cut: the vertices and triangles that are removed and inserted. A triangle
/// whose corners change is removed, and a new one is inserted at its position in the list.
struct SurfaceEdit {
  ListEdit vertices, triangles;
  // Inserted vertices: rest positions (m), the nodes and weights that they are embedded in, and permanent
  // numbers.
  std::vector<Vec3> positions;
  std::vector<SparseMap::Row> rows;
  std::vector<std::uint32_t> vertex_numbers;
  // Inserted triangles: their vertices by new indices, whether they are inner cut faces, and permanent
  // numbers.
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::uint8_t> inner;
  std::vector<std::uint32_t> triangle_numbers;
  /// Vertices of the edited surface that are corners of inserted triangles, or were corners of removed ones;
  /// by their new indices, ascending.
  std::vector<std::uint32_t> touched;
};

inline void apply(const SurfaceEdit& edit, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  PROSECTOR_ASSERT(triangles.size() == edit.triangles.now.size());
  if (!edit.vertices.keeps_indices())
    for (auto& corners : triangles)  // of those that go, too
      for (std::uint32_t& corner : corners) corner = edit.vertices.now[corner];
  apply(edit.triangles, edit.corners, triangles);
}

inline void apply(const SurfaceEdit& edit, TriangleMesh& surface) {
  PROSECTOR_ASSERT(edit.positions.size() == edit.vertices.come.size() &&
                   edit.rows.size() == edit.positions.size());
  PROSECTOR_ASSERT(is_ascending(edit.touched) &&
                   (edit.touched.empty() || edit.touched.back() < edit.vertices.size()));
  apply(edit.vertices, edit.positions, surface.positions);
  apply(edit, surface.triangles);
  apply(edit.triangles, edit.inner, surface.inner);
}

inline void apply(const SurfaceEdit& edit, Numbering& numbering) {
  apply(edit.vertices, edit.vertex_numbers, numbering.vertices);
  apply(edit.triangles, edit.triangle_numbers, numbering.triangles);
}

}  // namespace prosector
