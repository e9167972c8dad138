#pragma once
// Readers of surface files that are our own: PLY and STL, ASCII and binary.

#include <string>
#include <string_view>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Reads a surface from the file's bytes, in the file's units. Polygons are split into triangles; what is
/// left out is added to `notes`, one line each. Throws InputError that says what is wrong. Sizes that the
/// file claims allocate nothing before the bytes are there. Positions may not be finite.
TriangleMesh parse_ply(std::string_view bytes, std::vector<std::string>& notes);
TriangleMesh parse_stl(std::string_view bytes, std::vector<std::string>& notes);

}  // namespace prosector
