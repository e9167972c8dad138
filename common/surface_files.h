#pragma once
// File name endings of triangle surfaces (not tetrahedra or voxels).

#include <array>
#include <string_view>

namespace prosector {

inline constexpr std::array<std::string_view, 6> surface_endings = {".obj", ".stl",  ".ply",
                                                                    ".off", ".gltf", ".glb"};

/// Returns whether the file name has the ending of a triangle surface's format (such as .obj or .stl),
/// ignoring case.
bool is_surface_file(std::string_view file);

}  // namespace prosector
