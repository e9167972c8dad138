#pragma once
// Which files hold surfaces of triangles, and not tetrahedra or voxels.

#include <array>
#include <string_view>

namespace prosector {

inline constexpr std::array<std::string_view, 6> surface_endings = {".obj", ".stl",  ".ply",
                                                                    ".off", ".gltf", ".glb"};

/// Tells whether the file is a surface's by the end of its name, whatever its case.
bool is_surface_file(std::string_view file);

}  // namespace prosector
