#include "common/anatomy/sources.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>

#include "common/anatomy/anatomy_cache.h"
#include "common/anatomy/bytes.h"
#include "common/anatomy/embedding.h"
#include "common/anatomy/implicit.h"
#include "common/anatomy/isosurface.h"
#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/simplify.h"
#include "common/anatomy/stuffing.h"
#include "common/anatomy/surface_check.h"
#include "common/anatomy/surface_io.h"
#include "common/anatomy/tet_io.h"
#include "common/anatomy/volume_io.h"
#include "common/error.h"
#include "common/primitives.h"

namespace prosector {
namespace {

constexpr int recipe = 2;  // raised when the same source gives another mesh: old cache files then don't match

void say(const Progress& progress, const std::string& line) {
  if (progress) progress(line);
}

std::vector<std::filesystem::path> candidates(const std::string& file, const SourcePaths& paths) {
  if (std::filesystem::path(file).is_absolute()) return {file};
  std::vector<std::filesystem::path> out = {paths.scene_dir / file};
  for (const auto& dir : paths.data_dirs) out.push_back(dir / file);
  return out;
}

/// The first place that has the file; empty when missing but replaceable; throws when not.
std::filesystem::path resolve(const std::string& body, const std::string& file, const std::string& fallback,
                              const SourcePaths& paths, const Progress& progress) {
  std::vector<std::string> looked;
  for (const auto& path : candidates(file, paths)) {
    if (std::filesystem::is_regular_file(path)) return path;
    looked.push_back(path.string());
  }
  if (fallback.empty())
    throw InputError(fmt::format("{}: {} is missing; looked for {}. Fetch it, or name a fallback shape", body,
                                 file, fmt::join(looked, ", ")));
  say(progress,
      fmt::format("{}: {} is missing: using the implicit shape \"{}\" instead", body, file, fallback));
  return {};
}

ContentHash hash_of(const std::string& text) {
  return content_hash(std::as_bytes(std::span(text.data(), text.size())));
}

std::string file_hash(const std::filesystem::path& file) {
  const auto bytes = read_file(file);
  return to_hex(content_hash(std::as_bytes(std::span(bytes))));
}

Anatomy mesh_solid(const std::string& name, const SolidField& field, const SoftDesc& desc,
                   const Progress& progress) {
  TetMesh tets = stuff_solid(field, desc.cell);
  say(progress, fmt::format("{}: {}", name, describe(tet_quality(tets))));
  Embedding embedded = embed(std::move(tets), isosurface(field, desc.surface_cell));
  const Anatomy& a = embedded.anatomy;
  say(progress, fmt::format("{}: surface of {} triangles, {} of {} vertices outside the tetrahedra", name,
                            a.surface.triangles.size(), embedded.outside, a.surface.positions.size()));
  if (embedded.drawn_in > 0)
    say(progress,
        fmt::format(
            "{}: cell is too coarse for the shape's thin parts: {} surface vertices drawn in by up to "
            "{:.2g} mm",
            name, embedded.drawn_in, 1000 * embedded.farthest));
  return std::move(embedded.anatomy);
}

Anatomy mesh_volume(const std::filesystem::path& file, const SoftDesc& desc, const Progress& progress) {
  const std::string name = file.string();
  const Volume volume = load_volume(file);
  const int margin = smoothing_margin(desc.smoothing);
  const Mask mask = desc.label >= 0 ? mask_of_label(volume, desc.label, margin, name)
                                    : mask_above(volume, desc.threshold, margin, name);
  if (mask.dropped_pieces > 0)
    say(progress, fmt::format("{}: kept the largest of {} pieces ({} voxels dropped)", desc.name,
                              mask.dropped_pieces + 1, mask.dropped_voxels));
  return mesh_solid(desc.name, smooth_solid(mask, desc.smoothing), desc, progress);
}

// The mesh's own boundary is its surface.
Anatomy mesh_file(const std::filesystem::path& file, const SoftDesc& desc, const Progress& progress) {
  TetMesh tets = load_tets(file, desc.scale);
  say(progress, fmt::format("{}: {}", desc.name, describe(tet_quality(tets))));
  TriangleMesh surface{tets.positions, boundary_faces(tets)};
  drop_unused(surface);
  return embed(std::move(tets), std::move(surface)).anatomy;
}

Anatomy build(const SoftDesc& desc, const std::filesystem::path& file, const std::string& shape,
              const Progress& progress) {
  if (!shape.empty()) return mesh_solid(desc.name, implicit_shape(shape, desc.size), desc, progress);
  return desc.volume.empty() ? mesh_file(file, desc, progress) : mesh_volume(file, desc, progress);
}

}  // namespace

Anatomy make_anatomy(const SoftDesc& desc, const SourcePaths& paths, const Progress& progress) {
  std::string shape = desc.shape;
  std::filesystem::path file;
  if (shape.empty()) {
    const std::string& source = desc.volume.empty() ? desc.mesh : desc.volume;
    if (source.empty())
      throw InputError(fmt::format("{}: no geometry; allowed: volume, mesh or shape", desc.name));
    file = resolve(desc.name, source, desc.fallback, paths, progress);
    if (file.empty()) shape = desc.fallback;
  }
  const std::string made_from = shape.empty() ? file_hash(file) : shape;
  const ContentHash key =
      hash_of(fmt::format("soft {} {} {} {} {} {} {} {} {} {} {} {}", recipe, made_from, desc.volume.empty(),
                          desc.label, desc.threshold, desc.size[0], desc.size[1], desc.size[2], desc.scale,
                          desc.cell, desc.surface_cell, desc.smoothing));
  Anatomy anatomy;
  if (auto cached = load_cached(paths.cache_dir, key)) {
    anatomy = std::move(*cached);
    say(progress, fmt::format("{}: {} (cached)", desc.name, describe(tet_quality(anatomy.tets))));
  } else {
    anatomy = build(desc, file, shape, progress);
    store_cached(paths.cache_dir, key, anatomy);
  }
  const bool stands_in = desc.shape.empty() && file.empty();
  const Pose pose = stands_in ? desc.pose * desc.fallback_pose : desc.pose;
  for (Vec3& x : anatomy.tets.positions) x = pose * x;
  apply_embedding(anatomy);
  return anatomy;
}

TriangleMesh make_surface(const RigidDesc& desc, const SourcePaths& paths, const Progress& progress) {
  if (desc.mesh.empty() && desc.fallback.empty()) return mesh_of(desc.parts);
  const auto file = desc.mesh.empty() ? std::filesystem::path{}
                                      : resolve(desc.name, desc.mesh, desc.fallback, paths, progress);
  if (file.empty()) {
    const double cell = desc.surface_cell > 0 ? desc.surface_cell : desc.size.minCoeff() / 20;
    TriangleMesh surface = isosurface(implicit_shape(desc.fallback, desc.size), cell);
    for (Vec3& x : surface.positions) x = desc.fallback_pose * x;
    return surface;
  }
  const ContentHash key =
      hash_of(fmt::format("rigid {} {} {} {}", recipe, file_hash(file), desc.scale, desc.surface_cell));
  if (auto cached = load_cached(paths.cache_dir, key)) return std::move(cached->surface);
  Anatomy made;
  made.surface = load_surface(file, desc.scale);
  const std::size_t before = made.surface.triangles.size();
  if (desc.surface_cell > 0) made.surface = simplify(made.surface, desc.surface_cell);
  const SurfaceReport report = check_surface(made.surface);
  if (report.volume < 0)
    for (auto& t : made.surface.triangles) std::swap(t[1], t[2]);
  say(progress, fmt::format("{}: {} of {} triangles{}{}", desc.name, made.surface.triangles.size(), before,
                            report.warning().empty() ? "" : "; warning: ", report.warning()));
  store_cached(paths.cache_dir, key, made);
  return std::move(made.surface);
}

}  // namespace prosector
