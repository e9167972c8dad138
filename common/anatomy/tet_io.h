#pragma once
// Reading of tetrahedral mesh files: Gmsh 1, 2.2 and 4.1 ASCII (.msh), legacy VTK ASCII and binary (.vtk, up
// to version 5.1).

#include <filesystem>
#include <string>
#include <string_view>

#include "common/anatomy/mesh_reading.h"
#include "common/mesh.h"

namespace prosector {

/// Reads a tetrahedral mesh, times `scale` (to metres), repaired (tet_repair.h). Hexahedra, prisms and
/// pyramids are split into tetrahedra; of quadratic cells only the corners are used. Throws InputError with
/// file and line for
///   an unsupported file type, an index out of range, a position that isn't finite
///   an unknown element type
///   no tetrahedra, or overlapping elements
TetMesh load_tets(const std::filesystem::path& file, double scale, const MeshReadOptions& how = {});

/// Parses a tetrahedral mesh file; `name` is used in messages. Positions are as in the file, tetrahedra
/// unchecked.
TetMesh parse_gmsh(std::string_view text, const std::string& name, const Progress& report = {});
TetMesh parse_vtk(std::string_view text, const std::string& name, const Progress& report = {});

}  // namespace prosector
