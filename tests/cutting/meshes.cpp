#include "tests/cutting/meshes.h"

#include <random>

#include "common/anatomy/implicit.h"
#include "common/anatomy/isosurface.h"
#include "common/anatomy/kuhn_box.h"
#include "common/anatomy/stuffing.h"

namespace prosector {

TetMesh box_mesh(std::uint32_t cells) {
  return kuhn_box(Vec3::Constant(mesh_size), cells, cells, cells);
}

TetMesh ball_mesh(double cell) {
  TetMesh mesh = stuff_solid(implicit_shape("ball", Vec3::Constant(mesh_size)), cell);
  for (Vec3& x : mesh.positions) x += Vec3::Constant(mesh_size / 2);
  return mesh;
}

TriangleMesh surface_of(const char* shape, double cell) {
  TriangleMesh mesh = isosurface(implicit_shape(shape, Vec3::Constant(mesh_size)), cell);
  for (Vec3& x : mesh.positions) x += Vec3::Constant(mesh_size / 2);
  return mesh;
}

TetMesh single_tet() {
  TetMesh mesh;
  mesh.positions = {{0.01, 0.01, 0.01}, {0.09, 0.02, 0.01}, {0.02, 0.09, 0.02}, {0.03, 0.03, 0.09}};
  mesh.tets = {{0, 1, 2, 3}};
  return mesh;
}

TetMesh shaken_box(std::uint32_t cells) {
  TetMesh mesh = box_mesh(cells);
  std::mt19937 random(7);
  const double reach = 0.15 * mesh_size / cells;
  const auto uniform = [&] { return static_cast<double>(random()) / static_cast<double>(random.max()); };
  for (Vec3& x : mesh.positions) {
    const Vec3 shift = Vec3::NullaryExpr([&] { return reach * (2 * uniform() - 1); });
    const bool inside = x.minCoeff() > 1e-9 && x.maxCoeff() < mesh_size - 1e-9;
    if (inside) x += shift;
  }
  return mesh;
}

std::vector<NamedMesh> meshes_to_cut() {
  return {{"box", box_mesh(4)},
          {"ball", ball_mesh(0.016)},
          {"round_ball", ball_mesh(0.016), surface_of("ball", 0.008)},
          {"tet", single_tet()},
          {"shaken", shaken_box(4)}};
}

}  // namespace prosector
