#include "common/anatomy/mesh_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace prosector {
namespace {

using enum CellShape;

// Node numbers and orders: Gmsh reference manual, "MSH file format"; VTK User's Guide, "VTK file formats".
constexpr std::array gmsh_cells = {CellKind{1, "lines", flat, 2},
                                   CellKind{2, "triangles", flat, 3},
                                   CellKind{3, "quadrilaterals", flat, 4},
                                   CellKind{4, "tetrahedra", tetrahedron, 4},
                                   CellKind{5, "hexahedra", hexahedron, 8},
                                   CellKind{6, "prisms", prism, 6},
                                   CellKind{7, "pyramids", pyramid, 5},
                                   CellKind{8, "quadratic lines", flat, 3},
                                   CellKind{9, "quadratic triangles", flat, 6},
                                   CellKind{10, "quadratic quadrilaterals", flat, 9},
                                   CellKind{11, "quadratic tetrahedra", tetrahedron, 10},
                                   CellKind{12, "quadratic hexahedra", hexahedron, 27},
                                   CellKind{13, "quadratic prisms", prism, 18},
                                   CellKind{14, "quadratic pyramids", pyramid, 14},
                                   CellKind{15, "points", flat, 1},
                                   CellKind{16, "quadratic quadrilaterals", flat, 8},
                                   CellKind{17, "quadratic hexahedra", hexahedron, 20},
                                   CellKind{18, "quadratic prisms", prism, 15},
                                   CellKind{19, "quadratic pyramids", pyramid, 13},
                                   CellKind{20, "cubic triangles", flat, 9},
                                   CellKind{21, "cubic triangles", flat, 10},
                                   CellKind{22, "triangles of fourth order", flat, 12},
                                   CellKind{23, "triangles of fourth order", flat, 15},
                                   CellKind{24, "triangles of fifth order", flat, 15},
                                   CellKind{25, "triangles of fifth order", flat, 21},
                                   CellKind{26, "cubic lines", flat, 4},
                                   CellKind{27, "lines of fourth order", flat, 5},
                                   CellKind{28, "lines of fifth order", flat, 6},
                                   CellKind{29, "cubic tetrahedra", tetrahedron, 20},
                                   CellKind{30, "tetrahedra of fourth order", tetrahedron, 35},
                                   CellKind{31, "tetrahedra of fifth order", tetrahedron, 56},
                                   CellKind{92, "cubic hexahedra", hexahedron, 64},
                                   CellKind{93, "hexahedra of fourth order", hexahedron, 125}};

constexpr std::array vtk_cells = {CellKind{0, "empty cells", flat, 0},
                                  CellKind{1, "points", flat, 1},
                                  CellKind{2, "groups of points", flat, 0},
                                  CellKind{3, "lines", flat, 2},
                                  CellKind{4, "polylines", flat, 0},
                                  CellKind{5, "triangles", flat, 3},
                                  CellKind{6, "triangle strips", flat, 0},
                                  CellKind{7, "polygons", flat, 0},
                                  CellKind{8, "pixels", flat, 4},
                                  CellKind{9, "quadrilaterals", flat, 4},
                                  CellKind{10, "tetrahedra", tetrahedron, 4},
                                  CellKind{11, "voxels", voxel, 8},
                                  CellKind{12, "hexahedra", hexahedron, 8},
                                  CellKind{13, "prisms", prism, 6},
                                  CellKind{14, "pyramids", pyramid, 5},
                                  CellKind{21, "quadratic lines", flat, 3},
                                  CellKind{22, "quadratic triangles", flat, 6},
                                  CellKind{23, "quadratic quadrilaterals", flat, 8},
                                  CellKind{24, "quadratic tetrahedra", tetrahedron, 10},
                                  CellKind{25, "quadratic hexahedra", hexahedron, 20},
                                  CellKind{26, "quadratic prisms", prism, 15},
                                  CellKind{27, "quadratic pyramids", pyramid, 13},
                                  CellKind{28, "quadratic quadrilaterals", flat, 9},
                                  CellKind{29, "quadratic hexahedra", hexahedron, 27},
                                  CellKind{30, "quadratic quadrilaterals", flat, 6},
                                  CellKind{31, "quadratic prisms", prism, 12},
                                  CellKind{32, "quadratic prisms", prism, 18},
                                  CellKind{33, "quadratic hexahedra", hexahedron, 24},
                                  CellKind{34, "quadratic triangles", flat, 7},
                                  CellKind{35, "cubic lines", flat, 4},
                                  CellKind{36, "quadratic polygons", flat, 0},
                                  CellKind{37, "quadratic pyramids", pyramid, 19},
                                  CellKind{68, "Lagrange curves", flat, 0},
                                  CellKind{69, "Lagrange triangles", flat, 0},
                                  CellKind{70, "Lagrange quadrilaterals", flat, 0},
                                  CellKind{71, "Lagrange tetrahedra", tetrahedron, 0},
                                  CellKind{72, "Lagrange hexahedra", hexahedron, 0},
                                  CellKind{73, "Lagrange prisms", prism, 0},
                                  CellKind{74, "Lagrange pyramids", pyramid, 0}};

template <std::size_t n>
const CellKind* find(const std::array<CellKind, n>& kinds, int number) {
  const auto it = std::ranges::find(kinds, number, &CellKind::number);
  return it == kinds.end() ? nullptr : &*it;
}

using FaceCorners = std::vector<std::size_t>;  // three or four corners, in order around it

const std::vector<FaceCorners>& faces_of(CellShape shape) {
  static const std::vector<FaceCorners>
      hexahedra = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
      voxels = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}},
      prisms = {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}},
      pyramids = {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return shape == hexahedron ? hexahedra : shape == voxel ? voxels : shape == prism ? prisms : pyramids;
}

/// Splits a cell: adds the tetrahedra of its lowest node and each triangle of the faces that don't contain
/// it.
void split(CellShape shape, std::span<const std::uint32_t> corners, TetMesh& mesh) {
  const std::uint32_t lowest = *std::ranges::min_element(corners);
  for (const FaceCorners& face : faces_of(shape)) {
    std::vector<std::uint32_t> nodes;
    for (const std::size_t k : face) nodes.push_back(corners[k]);
    if (std::ranges::find(nodes, lowest) != nodes.end()) continue;
    std::ranges::rotate(nodes, std::ranges::min_element(nodes));
    for (std::size_t k = 1; k + 1 < nodes.size(); ++k)
      mesh.tets.push_back({lowest, nodes[0], nodes[k], nodes[k + 1]});
  }
}

}  // namespace

const CellKind* gmsh_cell(int number) {
  return find(gmsh_cells, number);
}

const CellKind* vtk_cell(int number) {
  return find(vtk_cells, number);
}

std::size_t corners_of(CellShape shape) {
  switch (shape) {
    case flat:
      return 0;
    case tetrahedron:
      return 4;
    case pyramid:
      return 5;
    case prism:
      return 6;
    case hexahedron:
    case voxel:
      return 8;
  }
  return 0;
}

void CellCollector::add(const CellKind& kind, std::span<const std::uint32_t> corners, TetMesh& mesh) {
  if (kind.shape == tetrahedron)
    mesh.tets.push_back({corners[0], corners[1], corners[2], corners[3]});
  else
    split(kind.shape, corners, mesh);
  if (kind.nodes != corners.size()) ++straightened_[kind.plural];
  if (kind.shape != tetrahedron) ++split_[kind.plural];
}

void CellCollector::report(const Progress& to) const {
  if (!to) return;
  for (const auto& [plural, count] : split_)
    to(fmt::format("repaired: {} {} are split into tetrahedra", count, plural));
  for (const auto& [plural, count] : straightened_)
    to(fmt::format("repaired: {} {} are replaced by linear elements with straight edges", count, plural));
  std::string skipped;
  for (const auto& [plural, count] : skipped_)
    skipped += fmt::format("{}{} {}", skipped.empty() ? "" : ", ", count, plural);
  if (!skipped.empty()) to(fmt::format("not used: {}", skipped));
}

std::string unknown_cell(std::uint64_t number) {
  return fmt::format(
      "the file has elements of type {}; allowed: tetrahedra, hexahedra, prisms and pyramids. Save the mesh "
      "with tetrahedra only",
      number);
}

}  // namespace prosector
