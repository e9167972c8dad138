#pragma once
// Collision shapes as white lines.

#include <array>
#include <vector>

#include "client/view/draw_list.h"
#include "common/mesh.h"

namespace prosector {

using Edges = std::vector<std::array<std::uint32_t, 2>>;

/// Returns every edge of the mesh once, as pairs of vertices, except edges between coplanar faces.
Edges visible_edges(const TriangleMesh& mesh);

/// Returns every edge of the triangles once, as pairs of vertices. Triangles with coincident corners have
/// none.
Edges all_edges(const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Adds the edges as white lines to the list. `place(vertex)` returns a vertex's position, m, world frame.
template <class Place>
void add_wireframe(DrawList& list, const Edges& edges, const Place& place) {
  for (const auto& [a, b] : edges)
    list.lines.push_back({.a = place(a), .b = place(b), .color = Vec3::Ones(), .width = 1.2});
}

}  // namespace prosector
