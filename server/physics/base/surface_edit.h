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

/// A triangle that got other corners goes, and comes at its place.
struct SurfaceEdit {
  ListEdit vertices, triangles;
  // Vertices that come: at rest, m; what they hang on; the numbers that they keep for ever.
  std::vector<Vec3> positions;
  std::vector<SparseMap::Row> rows;
  std::vector<std::uint32_t> vertex_numbers;
  // Triangles that come: vertices, by their indices now; whether they are inner; their numbers.
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::uint8_t> inner;
  std::vector<std::uint32_t> triangle_numbers;
  /// Vertices there now of triangles that went or came; ascending.
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
