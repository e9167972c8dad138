#include "common/anatomy/surface_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "common/anatomy/child_process.h"
#include "common/anatomy/coincident_points.h"
#include "common/anatomy/import_reply.h"
#include "common/anatomy/simplify.h"
#include "common/error.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/regular_file.h"

namespace prosector {
namespace {

constexpr std::size_t max_reply_bytes = std::size_t{1} << 30;

/// Reads the file in a separate process. Throws InputError with the reader's message, or the way that the
/// process failed.
TriangleMesh import(const std::filesystem::path& file, const MeshReadOptions& how) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(
        fmt::format("{}: not a surface ({}); allowed: OBJ, STL, PLY, OFF, glTF", file.string(), why));
  };
  const auto reader = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "prosector-import";
  const ChildOutcome child =
      run_child(reader, {std::filesystem::absolute(file).string()}, {how.time_limit, max_reply_bytes});
  if (!child.error.empty()) refuse(fmt::format("its reader {} {}", reader.filename().string(), child.error));
  ImportReply reply;
  try {
    reply = decode_import_reply(child.output);
  } catch (const InputError& error) {
    refuse(error.what());
  }
  if (!reply.refusal.empty()) refuse(reply.refusal);
  if (how.report) std::ranges::for_each(reply.notes, how.report);
  return std::move(reply.mesh);
}

// Merges vertices at equal positions: readers duplicate vertices where normals or seams differ.
void merge_equal(TriangleMesh& mesh) {
  std::map<std::array<double, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> number(mesh.positions.size());
  for (std::uint32_t v = 0; v < number.size(); ++v) {
    const Vec3& x = mesh.positions[v];
    number[v] = first.try_emplace({x[0], x[1], x[2]}, v).first->second;
  }
  for (auto& t : mesh.triangles)
    for (auto& v : t) v = number[v];
  drop_unused(mesh);
}

/// Warns if the coordinates are so large that single precision distorts the shape.
void report_rounding(const TriangleMesh& mesh, const Progress& report) {
  double largest = 0;
  for (const Vec3& x : mesh.positions) largest = std::max(largest, x.cwiseAbs().maxCoeff());
  const double extent = extent_of(mesh.positions), step = largest * 0x1p-23;
  constexpr double visible = 1e-3;  // fraction of the extent
  if (report && step > visible * extent)
    report(
        fmt::format("warning: its coordinates reach {:.6g}: single precision rounds them to {:.2g}, at a "
                    "size of {:.4g} (file units). Move it to its origin in a mesh editor",
                    largest, step, extent));
}

}  // namespace

TriangleMesh load_unscaled_surface(const std::filesystem::path& file, const MeshReadOptions& how) {
  const std::string name = file.string();
  require_regular_file(file);
  if (!std::filesystem::exists(file)) throw InputError(fmt::format("{}: no such file", name));
  TriangleMesh mesh = import(file, how);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (!mesh.positions[v].allFinite())
      throw InputError(fmt::format("{}: vertex {} is not a finite position", name, v));
  merge_equal(mesh);
  if (mesh.triangles.empty()) throw InputError(fmt::format("{}: no triangles; allowed: at least one", name));
  report_rounding(mesh, how.report);
  return mesh;
}

TriangleMesh load_surface(const std::filesystem::path& file, double scale, const MeshReadOptions& how) {
  if (!(scale > 0) || !std::isfinite(scale))
    throw InputError(fmt::format("{}: scale {}; allowed: above 0", file.string(), scale));
  TriangleMesh mesh = load_unscaled_surface(file, how);
  Eigen::AlignedBox3d box;
  for (Vec3& x : mesh.positions) box.extend(x = scale * (x - how.origin));
  const double extent = box.sizes().maxCoeff();
  constexpr double max_extent = 100, min_extent = 1e-4;
  if (!(extent >= min_extent && extent <= max_extent))
    throw InputError(
        fmt::format("{}: the mesh is {} m across at scale {}; allowed: {} to {} m (is the file in "
                    "millimetres? scale = 0.001)",
                    file.string(), extent, scale, min_extent, max_extent));
  if (const Vec3 middle = box.center(); middle.cwiseAbs().maxCoeff() > max_coordinate) {
    const Vec3 in_file = middle / scale + how.origin;
    throw InputError(
        fmt::format("{}: the mesh is {:.4g} m from the file's origin at scale {}; allowed: at most {:.4g} m. "
                    "Set the origin: mesh_origin = [{:.6g}, {:.6g}, {:.6g}]",
                    file.string(), middle.norm(), scale, max_coordinate, in_file[0], in_file[1], in_file[2]));
  }
  return mesh;
}

}  // namespace prosector
