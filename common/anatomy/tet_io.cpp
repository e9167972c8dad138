#include "common/anatomy/tet_io.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/anatomy/bytes.h"
#include "common/anatomy/tet_repair.h"
#include "common/error.h"
#include "common/file_endings.h"
#include "common/ids.h"
#include "common/surface_files.h"

namespace prosector {
namespace {

void refuse_other_kinds(const std::filesystem::path& file) {
  if (has_ending(file.native(), ".msh") || has_ending(file.native(), ".vtk")) return;
  throw InputError(
      fmt::format("{}: not a tetrahedral mesh; allowed: .msh (Gmsh), .vtk (legacy VTK), or a closed "
                  "surface to fill ({})",
                  file.string(), fmt::join(surface_endings, " ")));
}

}  // namespace

TetMesh load_tets(const std::filesystem::path& file, double scale, const MeshReadOptions& how) {
  const std::string name = file.string();
  refuse_other_kinds(file);
  const auto bytes = read_file(file);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  TetMesh mesh =
      has_ending(name, ".msh") ? parse_gmsh(text, name, how.report) : parse_vtk(text, name, how.report);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v] = scale * (mesh.positions[v] - how.origin);
    if (!(mesh.positions[v].norm() <= max_coordinate))
      throw InputError(fmt::format(
          "{}: point {} is not within 1000 m of the origin at scale {}; reduce scale or set mesh_origin",
          name, v, scale));
  }
  return repaired(std::move(mesh), name, how.report);
}

}  // namespace prosector
