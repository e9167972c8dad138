#pragma once
// Reading of tetrahedral mesh files: Gmsh 1, 2.2 and 4.1 ASCII (.msh), legacy VTK ASCII and binary (.vtk, up
// to version 5.1).

#include <filesystem>
#include <string>
#include <string_view>

#include "common/anatomy/mesh_reading.h"
#include "common/mesh.h"

namespace prosector {

/// Reads a tetrahedral mesh file, with positions times `scale` (to metres), and repairs common faults
/// (tet_repair.h). Hexahedra, prisms and pyramids are split into tetrahedra; of quadratic cells only the
/// corners are used. Throws InputError with file and line for
///   an unsupported file type, an index out of range, a position that isn't finite,
///   an unknown element type, and
///   no tetrahedra, or overlapping elements.
TetMesh load_tets(const std::filesystem::path& file, double scale, const MeshReadOptions& how = {});

/// Parses a tetrahedral mesh from the text of a Gmsh file (parse_gmsh) or a VTK file (parse_vtk); `name` is
/// used in messages. Positions are as in the file, and tetrahedra are not checked.
TetMesh parse_gmsh(std::string_view text, const std::string& name, const Progress& report = {});
TetMesh parse_vtk(std::string_view text, const std::string& name, const Progress& report = {});

}  // namespace prosector
