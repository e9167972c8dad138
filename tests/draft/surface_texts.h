#pragma once
// Surfaces made up by the tests, and files of them.

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "common/anatomy/implicit.h"
#include "common/anatomy/isosurface.h"
#include "common/mesh.h"

namespace prosector {

/// A shape of ours as a surface of about `edge` m.
inline TriangleMesh surface_of(const std::string& shape, const Vec3& size, double edge) {
  return isosurface(implicit_shape(shape, size), edge);
}

/// A box of twelve triangles from `low` to `high`, facing outward.
inline TriangleMesh box_surface(const Vec3& low, const Vec3& high) {
  TriangleMesh out;
  for (int k = 0; k < 8; ++k)
    out.positions.emplace_back((k & 1) ? high[0] : low[0], (k & 2) ? high[1] : low[1],
                               (k & 4) ? high[2] : low[2]);
  out.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return out;
}

inline std::string as_obj(const TriangleMesh& mesh, double per_metre) {
  std::string out;
  for (const Vec3& x : mesh.positions)
    out += fmt::format("v {} {} {}\n", per_metre * x[0], per_metre * x[1], per_metre * x[2]);
  for (const auto& t : mesh.triangles) out += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return out;
}

inline std::string as_off(const TriangleMesh& mesh, double per_metre) {
  std::string out = fmt::format("OFF\n{} {} 0\n", mesh.positions.size(), mesh.triangles.size());
  for (const Vec3& x : mesh.positions)
    out += fmt::format("{} {} {}\n", per_metre * x[0], per_metre * x[1], per_metre * x[2]);
  for (const auto& t : mesh.triangles) out += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return out;
}

inline std::string as_ply(const TriangleMesh& mesh, double per_metre) {
  std::string out = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.positions.size(), mesh.triangles.size());
  for (const Vec3& x : mesh.positions)
    out += fmt::format("{} {} {}\n", per_metre * x[0], per_metre * x[1], per_metre * x[2]);
  for (const auto& t : mesh.triangles) out += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return out;
}

/// Each triangle has vertices of its own, as the format wants.
inline std::string as_stl(const TriangleMesh& mesh, double per_metre) {
  std::string out = "solid s\n";
  for (const auto& t : mesh.triangles) {
    out += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t v : t) {
      const Vec3 x = per_metre * mesh.positions[v];
      out += fmt::format("vertex {} {} {}\n", x[0], x[1], x[2]);
    }
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid s\n";
}

inline std::string as_text(const std::filesystem::path& file, const TriangleMesh& mesh, double per_metre) {
  const std::string ending = file.extension().string();
  return ending == ".obj"   ? as_obj(mesh, per_metre)
         : ending == ".off" ? as_off(mesh, per_metre)
         : ending == ".ply" ? as_ply(mesh, per_metre)
                            : as_stl(mesh, per_metre);
}

}  // namespace prosector
