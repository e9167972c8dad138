#pragma once
// Reading of surface files: OBJ, STL, PLY, OFF, glTF.

#include <filesystem>

#include "common/anatomy/mesh_reading.h"
#include "common/mesh.h"

namespace prosector {

/// Reads all triangles of the file as one mesh, with node transforms applied, times `scale` (to metres),
/// equal vertices merged, degenerate triangles dropped. Throws InputError for
///   a missing or unreadable file, with the reader's message
///   no triangles, or a position that isn't finite
///   an extent above 100 m or under 0.1 mm
///   a position farther than 1000 m from the origin
/// The file is read in a separate process, prosector-import next to this executable. If that process crashes,
/// uses too much memory or takes longer than `how.patience`, the file is refused.
TriangleMesh load_surface(const std::filesystem::path& file, double scale, const MeshReadOptions& how = {});

/// Reads a surface as load_surface() does, but in the file's units and origin, without limits on its extent.
TriangleMesh load_unscaled_surface(const std::filesystem::path& file, const MeshReadOptions& how = {});

}  // namespace prosector
