#include "common/anatomy/tet_io.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "common/anatomy/bytes.h"
#include "common/anatomy/mesh_quality.h"
#include "common/error.h"
#include "common/surface_files.h"

namespace prosector {
namespace {

void refuse_other_kinds(const std::filesystem::path& file) {
  const std::string kind = file.extension().string();
  if (kind == ".msh" || kind == ".vtk") return;
  throw InputError(
      fmt::format("{}: not a tetrahedral mesh; allowed: .msh (Gmsh), .vtk (legacy VTK), or a closed "
                  "surface to fill ({})",
                  file.string(), fmt::join(surface_endings, " ")));
}

}  // namespace

TetMesh load_tets(const std::filesystem::path& file, double scale) {
  const std::string name = file.string();
  refuse_other_kinds(file);
  const auto bytes = read_file(file);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  TetMesh mesh = file.extension() == ".msh" ? parse_gmsh(text, name) : parse_vtk(text, name);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v] *= scale;
    if (!(mesh.positions[v].norm() <= 1000))
      throw InputError(fmt::format("{}: point {} is not within 1000 m at scale {}", name, v, scale));
  }
  std::vector<bool> keep;
  for (auto& t : mesh.tets) {
    const auto& x = mesh.positions;
    const double volume = tet_volume(x[t[0]], x[t[1]], x[t[2]], x[t[3]]);
    if (volume < 0) std::swap(t[2], t[3]);
    double longest = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, (x[t[i]] - x[t[j]]).norm());
    constexpr double flat = 1e-6;  // of the longest edge's cube: no stress can be computed in it
    keep.push_back(std::abs(volume) > flat * longest * longest * longest);
  }
  mesh = subset(mesh, keep);
  if (mesh.tets.empty()) throw InputError(fmt::format("{}: no tetrahedra; allowed: at least one", name));
  return mesh;
}

}  // namespace prosector
