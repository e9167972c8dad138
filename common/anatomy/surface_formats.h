#pragma once
// Built-in readers of surface files: PLY and STL, ASCII and binary.

#include <string>
#include <string_view>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Parses a PLY file (parse_ply) or an STL file (parse_stl) from its bytes, in the file's units. Polygons are
/// split into triangles. Content that is omitted is reported in `notes`, one line each. Throws InputError
/// that describes the error. Memory is allocated only for data that is present, whatever sizes the file
/// claims. Positions may be NaN or infinite.
TriangleMesh parse_ply(std::string_view bytes, std::vector<std::string>& notes);
TriangleMesh parse_stl(std::string_view bytes, std::vector<std::string>& notes);

}  // namespace prosector
