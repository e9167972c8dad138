#pragma once
// Tetrahedral meshes from files: Gmsh 1, 2.2 and 4.1 ASCII (.msh), legacy VTK ASCII and binary (.vtk,
// versions to 5.1).

#include <filesystem>
#include <string>
#include <string_view>

#include "common/anatomy/mesh_reading.h"
#include "common/mesh.h"

namespace prosector {

/// Reads a tetrahedral mesh, times `scale` (to metres), repaired (tet_repair.h). Hexahedra, prisms and
/// pyramids are split into tetrahedra; quadratic cells are taken by their corners. Throws InputError with
/// file and line for
///   a file of another kind, an index out of range, a position that isn't finite
///   a kind of element that isn't known
///   no tetrahedra, or elements that lie in each other
TetMesh load_tets(const std::filesystem::path& file, double scale, const MeshReading& how = {});

/// Reads a tetrahedral mesh from text, by format; `name` is for messages. Positions are as in the file,
/// tetrahedra unchecked.
TetMesh parse_gmsh(std::string_view text, const std::string& name, const Progress& report = {});
TetMesh parse_vtk(std::string_view text, const std::string& name, const Progress& report = {});

}  // namespace prosector
