#pragma once
// Random meshes and streamed surfaces that are valid assets.

#include <random>

#include "common/asset.h"

namespace prosector::testing_assets {

inline TriangleMesh random_mesh(std::mt19937_64& random, std::uint32_t vertices, std::uint32_t triangles) {
  std::uniform_real_distribution<double> place(-5, 5);
  TriangleMesh mesh;
  for (std::uint32_t v = 0; v < vertices; ++v)
    mesh.positions.emplace_back(place(random), place(random), place(random));
  for (std::uint32_t t = 0; t < triangles && vertices > 0; ++t) {
    const auto index = [&] { return static_cast<std::uint32_t>(random() % vertices); };
    mesh.triangles.push_back({index(), index(), index()});
  }
  return mesh;
}

inline StreamedSurface random_surface(std::mt19937_64& random, std::uint32_t rows, std::uint32_t points) {
  std::uniform_real_distribution<double> weight(-1, 1);
  StreamedSurface surface;
  surface.rest = random_mesh(random, points, 0).positions;
  for (std::uint32_t r = 0; r < rows; ++r) {
    SparseMap::Row row;
    for (auto& node : row.node) node = static_cast<std::uint32_t>(random() % points);
    for (std::size_t k = 0; k < 3; ++k) row.weight[k] = weight(random);
    row.weight[3] = 1 - row.weight[0] - row.weight[1] - row.weight[2];
    surface.map.rows.push_back(row);
  }
  return surface;
}

}  // namespace prosector::testing_assets
