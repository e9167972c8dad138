#pragma once
// Cells of volume mesh files (hexahedra, quadratic tetrahedra, ...) as linear tetrahedra.

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
};  // flat: not of three dimensions

/// A kind of cell, as a file format numbers it.
struct CellKind {
  int number;
  std::string_view plural;
  CellShape shape;
  std::size_t nodes;  // corners first; 0: as many as a file says
};

/// Returns the kinds that Gmsh or VTK files number; null: an unknown kind.
const CellKind* gmsh_cell(int number);
const CellKind* vtk_cell(int number);

/// Returns how many corners cells of this shape have.
std::size_t corners_of(CellShape shape);

/// Collects a file's cells as tetrahedra, and counts what was done with each kind.
class CellCollector {
 public:
  /// Adds a cell by its corners. Anything but a tetrahedron is split into tetrahedra, quadrilateral faces
  /// along the diagonal from their lowest node, so that neighbours agree.
  void add(const CellKind& kind, std::span<const std::uint32_t> corners, TetMesh& mesh);
  /// Counts a cell that isn't of three dimensions.
  void skip(const CellKind& kind) { ++skipped_[kind.plural]; }
  /// Reports each kind that was split, or used without its mid-edge nodes, or not used.
  void report(const Progress& to) const;

 private:
  std::map<std::string_view, std::size_t> split_, straightened_, skipped_;
};

/// Returns what to say of a kind of cell that isn't known.
std::string unknown_cell(std::uint64_t number);

}  // namespace prosector
