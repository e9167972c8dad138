#pragma once
// Meshes to cut, each within about [0, 1]³ · 0.1 m.

#include <string>
#include <vector>

#include "common/mesh.h"

namespace prosector {

struct NamedMesh {
  std::string name;
  TetMesh mesh;
  TriangleMesh surface = {};  // finer than its boundary; empty: none
};

inline constexpr double mesh_size = 0.1;      // m
inline constexpr double mesh_density = 1060;  // kg/m³

TetMesh box_mesh(std::uint32_t cells);
TetMesh ball_mesh(double cell);                           // m
TriangleMesh surface_of(const char* shape, double cell);  // of a shape of our own, as large
TetMesh single_tet();
TetMesh shaken_box(std::uint32_t cells);  // interior nodes displaced at random
std::vector<NamedMesh> meshes_to_cut();

}  // namespace prosector
