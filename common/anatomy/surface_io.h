#pragma once
// Reading of surface files: OBJ, STL, PLY, OFF, glTF.

#include <filesystem>

#include "common/anatomy/mesh_reading.h"
#include "common/mesh.h"

namespace prosector {

/// Reads all triangles of a surface file as one mesh, with node transforms applied. Positions are multiplied
/// by `scale` (to metres), equal vertices are merged, and degenerate triangles are removed.
/// Throws InputError for
///   a missing or unreadable file, with the reader's message,
///   no triangles, or a position that isn't finite,
///   an extent above 100 m or under 0.1 mm, and
///   a position farther than 1000 m from the origin.
/// The file is read in a separate process, prosector-import next to this executable. If that process crashes,
/// uses too much memory or takes longer than `how.time_limit`, the file is refused.
TriangleMesh load_surface(const std::filesystem::path& file, double scale, const MeshReadOptions& how = {});

/// Reads all triangles of a surface file as one mesh, with the same checks as load_surface(), but in the
/// file's units and origin, and without limits on its extent.
TriangleMesh load_unscaled_surface(const std::filesystem::path& file, const MeshReadOptions& how = {});

}  // namespace prosector
