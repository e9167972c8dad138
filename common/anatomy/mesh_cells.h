#pragma once
// Conversion of cells of volume mesh files (hexahedra, quadratic tetrahedra, ...) to linear tetrahedra.

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "common/anatomy/progress.h"
#include "common/mesh.h"

namespace prosector {

enum class CellShape {
  flat,
  tetrahedron,
  pyramid,
  prism,
  hexahedron,
  voxel
};  // flat: of fewer than three dimensions

/// A cell type of a volume mesh file format: its number in the file, its name, shape and number of nodes.
struct CellKind {
  int number;
  std::string_view plural;
  CellShape shape;
  std::size_t nodes;  // number of nodes, corners first; 0: variable, given in the file
};

/// Returns the cell type with this number in Gmsh files (gmsh_cell) or VTK files (vtk_cell); null if it is
/// unknown.
const CellKind* gmsh_cell(int number);
const CellKind* vtk_cell(int number);

/// Returns the number of corner nodes of a volume mesh's cell of this shape.
std::size_t corners_of(CellShape shape);

/// Converter of a mesh file's cells to tetrahedra, which counts the conversions by cell type.
class CellCollector {
 public:
  /// Appends a cell, given by its corner nodes, to `mesh`. Cells other than tetrahedra are split into
  /// tetrahedra. Quadrilateral faces are split along the diagonal from their lowest node, so that adjacent
  /// cells match.
  void add(const CellKind& kind, std::span<const std::uint32_t> corners, TetMesh& mesh);
  /// Counts a cell of fewer than three dimensions, which is not used in the mesh.
  void skip(const CellKind& kind) { ++skipped_[kind.plural]; }
  /// Reports, to the progress callback, each cell type that was split, used without its mid-edge nodes, or
  /// not used.
  void report(const Progress& to) const;

 private:
  std::map<std::string_view, std::size_t> split_, straightened_, skipped_;
};

/// Returns the error message for a mesh file's cell type `number` that is unknown.
std::string unknown_cell(std::uint64_t number);

}  // namespace prosector
