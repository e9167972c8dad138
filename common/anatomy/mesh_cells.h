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

/// A cell type of a file format.
struct CellKind {
  int number;
  std::string_view plural;
  CellShape shape;
  std::size_t nodes;  // number of nodes, corners first; 0: variable, given in the file
};

/// Returns the cell type with this number in Gmsh or VTK files; null if it is unknown.
const CellKind* gmsh_cell(int number);
const CellKind* vtk_cell(int number);

/// Returns the number of corners of a cell of this shape.
std::size_t corners_of(CellShape shape);

/// Converts a file's cells to tetrahedra and counts the conversions by cell type.
class CellCollector {
 public:
  /// Adds a cell by its corners. Cells other than tetrahedra are split into tetrahedra. Quadrilateral faces
  /// are split along the diagonal from their lowest node, so that adjacent cells match.
  void add(const CellKind& kind, std::span<const std::uint32_t> corners, TetMesh& mesh);
  /// Counts a cell of fewer than three dimensions, which is not used.
  void skip(const CellKind& kind) { ++skipped_[kind.plural]; }
  /// Reports each cell type that was split, used without its mid-edge nodes, or not used.
  void report(const Progress& to) const;

 private:
  std::map<std::string_view, std::size_t> split_, straightened_, skipped_;
};

/// Returns the error message for an unknown cell type.
std::string unknown_cell(std::uint64_t number);

}  // namespace prosector
