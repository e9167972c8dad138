#pragma once
// Tetrahedral meshes from files: Gmsh 2.2 and 4.1 ASCII (.msh), legacy VTK ASCII and binary (.vtk, versions
// to 5.1).

#include <filesystem>
#include <string>
#include <string_view>

#include "common/mesh.h"

namespace prosector {

/// Reads a tetrahedral mesh, times `scale` (to metres); inverted tetrahedra are turned, flat ones dropped.
/// Throws InputError with file and line: not such a file, an index out of range, a position that isn't
/// finite, no tetrahedra.
TetMesh load_tets(const std::filesystem::path& file, double scale);

/// Reads a tetrahedral mesh from text, by format; `name` is for messages. Positions are as in the file,
/// tetrahedra unchecked.
TetMesh parse_gmsh(std::string_view text, const std::string& name);
TetMesh parse_vtk(std::string_view text, const std::string& name);

}  // namespace prosector
