#pragma once
// Surfaces from files: OBJ, STL, PLY, OFF, glTF.

#include <filesystem>

#include "common/anatomy/mesh_reading.h"
#include "common/mesh.h"

namespace prosector {

/// Reads all triangles of the file as one mesh, its nodes' transforms applied, times `scale` (to metres),
/// equal vertices merged, degenerate triangles dropped. Throws InputError for
///   a missing or unreadable file, with the reader's words
///   no triangles, or a position that isn't finite
///   an extent above 100 m or under 0.1 mm
///   a place farther than 1000 m from the origin
/// The file is read by a process of its own, prosector-import beside this program. Where that crashes, uses
/// too much or takes longer than `how.patience`, the file is refused.
TriangleMesh load_surface(const std::filesystem::path& file, double scale, const MeshReading& how = {});

/// Reads the same in the file's own units and origin, whatever its extent.
TriangleMesh load_unscaled_surface(const std::filesystem::path& file, const MeshReading& how = {});

}  // namespace prosector
