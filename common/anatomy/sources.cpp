#include "common/anatomy/sources.h"

#include <fmt/format.h>

#include <span>

#include "common/anatomy/anatomy_cache.h"
#include "common/anatomy/bytes.h"
#include "common/anatomy/embedding.h"
#include "common/anatomy/fabric.h"
#include "common/anatomy/implicit.h"
#include "common/anatomy/isosurface.h"
#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/quartered.h"
#include "common/anatomy/simplify.h"
#include "common/anatomy/stuffing.h"
#include "common/anatomy/surface_check.h"
#include "common/anatomy/surface_field.h"
#include "common/anatomy/surface_io.h"
#include "common/anatomy/tet_io.h"
#include "common/anatomy/volume_io.h"
#include "common/curves/from_scene.h"
#include "common/error.h"
#include "common/primitives.h"
#include "common/surface_files.h"

namespace prosector {
namespace {

constexpr int recipe = 2;  // raised when the same source gives another mesh: old cache files then don't match

void say(const Progress& progress, const std::string& line) {
  if (progress) progress(line);
}

/// Finds the first place that has the file; empty when missing but replaceable; throws when not.
std::filesystem::path resolve(const std::string& body, const std::string& file, const std::string& fallback,
                              const SourcePaths& paths, const Progress& progress) {
  if (auto found = find_source(file, paths); !found.empty()) return found;
  if (fallback.empty())
    throw InputError(fmt::format("{}: {}, or name a fallback shape", body, missing_source(file, paths)));
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

/// Returns what `make()` gives; what it refuses names the body, too.
template <class Make>
auto of_body(const std::string& name, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", name, error.what()));
  }
}

CachedAnatomy mesh_solid(const std::string& name, const SolidField& field, const SoftDesc& desc,
                         const Progress& progress) {
  constexpr double takes_a_while = 2e5;  // tetrahedra
  if (const double tets = expected_tets(field, desc.cell); tets > takes_a_while && tets < max_tets)
    say(progress,
        fmt::format("{}: meshing with about {:.2g} tetrahedra takes a while; Ctrl-C ends it", name, tets));
  TetMesh tets = stuff_solid(field, desc.cell);
  say(progress, fmt::format("{}: {}", name, describe(tet_quality(tets))));
  Embedding embedded = embed(std::move(tets), isosurface(field, desc.surface_cell));
  const Anatomy& a = embedded.anatomy;
  say(progress, fmt::format("{}: surface of {} triangles, {} of {} vertices outside the tetrahedra", name,
                            a.surface.triangles.size(), embedded.outside, a.surface.positions.size()));
  std::string warning;
  if (embedded.drawn_in > 0)
    warning = fmt::format(
        "cell is too coarse for the shape's thin parts: {} surface vertices drawn in by up to {:.2g} mm",
        embedded.drawn_in, 1000 * embedded.farthest);
  return {std::move(embedded.anatomy), std::move(warning)};
}

/// Makes the structure for a SoftDesc or a RigidDesc: both name a volume's structure alike.
template <class Desc>
SolidField structure_of(const Volume& volume, const std::string& name, const Desc& desc,
                        const Progress& progress) {
  const int margin = smoothing_margin(desc.smoothing);
  const Mask mask = desc.label >= 0 ? mask_of_label(volume, desc.label, margin, name)
                                    : mask_above(volume, desc.threshold, margin, name);
  if (mask.dropped_pieces > 0)
    say(progress, fmt::format("{}: kept the largest of {} pieces ({} voxels dropped)", desc.name,
                              mask.dropped_pieces + 1, mask.dropped_voxels));
  return smooth_solid(mask, desc.smoothing);
}

// Whether a mesh file's surface has a vertex on each edge, as quadratic elements have a node there: a load on
// corners alone is none that they are made for.
bool halves_edges(const SoftDesc& desc) {
  return desc.element == "tet10";
}

// The mesh's own boundary is its surface.
CachedAnatomy mesh_file(const std::filesystem::path& file, const SoftDesc& desc, const Progress& progress) {
  TetMesh tets = load_tets(file, desc.scale);
  say(progress, fmt::format("{}: {}", desc.name, describe(tet_quality(tets))));
  TriangleMesh surface{tets.positions, boundary_faces(tets)};
  drop_unused(surface);
  std::string warning = check_surface(surface).warning();
  if (halves_edges(desc)) surface = quartered(std::move(surface));
  return {embed(std::move(tets), std::move(surface)).anatomy, std::move(warning)};
}

/// Fills a closed surface.
CachedAnatomy fill_surface(const std::filesystem::path& file, const SoftDesc& desc,
                           const Progress& progress) {
  TriangleMesh surface = load_surface(file, desc.scale);
  if (const std::size_t pieces = surface_pieces(surface); pieces > 1)
    say(progress, fmt::format("{}: {} surfaces in the file: the largest solid between them is kept",
                              desc.name, pieces));
  const std::size_t crossings = intersecting_triangles(surface).size();
  const SolidField field = of_body(file.string(), [&] { return solid_within(std::move(surface)); });
  CachedAnatomy made = mesh_solid(desc.name, field, desc, progress);
  if (crossings > 0)
    made.warning += fmt::format("{}its surface intersects itself: {} pairs of triangles",
                                made.warning.empty() ? "" : "; ", crossings);
  return made;
}

CachedAnatomy build(const SoftDesc& desc, const std::filesystem::path& file, const std::string& shape,
                    const Progress& progress) {
  if (!shape.empty()) return mesh_solid(desc.name, implicit_shape(shape, desc.size), desc, progress);
  if (is_surface_file(desc.mesh)) return fill_surface(file, desc, progress);
  if (desc.volume.empty()) return mesh_file(file, desc, progress);
  return mesh_solid(desc.name, structure_of(load_volume(file), file.string(), desc, progress), desc,
                    progress);
}

TriangleMesh read_surface(const std::filesystem::path& file, const RigidDesc& desc,
                          const Progress& progress) {
  if (!desc.volume.empty()) {
    const Volume volume = load_volume(file);
    const double cell = desc.surface_cell > 0 ? desc.surface_cell : volume.voxel_size.maxCoeff();
    return isosurface(structure_of(volume, file.string(), desc, progress), cell);
  }
  TriangleMesh surface = load_surface(file, desc.scale);
  return desc.surface_cell > 0 ? simplify(surface, desc.surface_cell) : surface;
}

CachedAnatomy build(const RigidDesc& desc, const std::filesystem::path& file, const Progress& progress) {
  CachedAnatomy made;
  TriangleMesh& surface = made.anatomy.surface;
  surface = read_surface(file, desc, progress);
  const SurfaceReport report = check_surface(surface);
  made.warning = report.warning();
  if (report.volume < 0)
    for (auto& t : surface.triangles) std::swap(t[1], t[2]);
  return made;
}

/// Makes a sheet or rope, straight or along what the scene says.
Anatomy make_fabric(const SoftDesc& desc) {
  if (desc.shape == "rope" && !desc.curves.empty())
    return make_rope(make_curve(desc.curves.front()), desc.curves.front().diameter, desc.cell);
  if (desc.shape == "rope") return make_rope(desc.size, desc.cell);
  if (!desc.patches.empty())
    return make_sheet(*make_patch(desc.patches.front()), desc.patches.front().thickness, desc.cell);
  return make_sheet(desc.size, desc.cell);
}

void warn(const std::string& name, const CachedAnatomy& made, const Progress& progress) {
  if (!made.warning.empty()) say(progress, fmt::format("{}: warning: {}", name, made.warning));
}

/// Takes a mesh from the cache. A damaged file is told of, and none is returned: the mesh is made again.
std::optional<CachedAnatomy> take_cached(const std::string& name, const SourcePaths& paths,
                                         const ContentHash& key, const Progress& progress) {
  FoundAnatomy found = load_cached(paths.cache_dir, key);
  if (!found.trouble.empty())
    say(progress, fmt::format("{}: its mesh in the cache {}: made anew", name, found.trouble));
  return std::move(found.made);
}

}  // namespace

Anatomy make_anatomy(const SoftDesc& desc, const SourcePaths& paths, const Progress& progress) {
  if (desc.shape == "sheet" || desc.shape == "rope") {
    Anatomy made = of_body(desc.name, [&] { return make_fabric(desc); });
    for (Vec3& x : made.tets.positions) x = desc.pose * x;
    apply_embedding(made);
    return made;
  }
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
  const bool own_boundary = shape.empty() && desc.volume.empty() && !is_surface_file(desc.mesh);
  const ContentHash key = hash_of(fmt::format(
      "soft {} {} {} {} {} {} {} {} {} {} {} {}{}", recipe, made_from, desc.volume.empty(), desc.label,
      desc.threshold, desc.size[0], desc.size[1], desc.size[2], desc.scale, desc.cell, desc.surface_cell,
      desc.smoothing, own_boundary && halves_edges(desc) ? " halved edges" : ""));
  CachedAnatomy made;
  if (auto cached = take_cached(desc.name, paths, key, progress)) {
    made = std::move(*cached);
    say(progress, fmt::format("{}: {} (cached)", desc.name, describe(tet_quality(made.anatomy.tets))));
  } else {
    made = of_body(desc.name, [&] { return build(desc, file, shape, progress); });
    store_cached(paths.cache_dir, key, made);
  }
  warn(desc.name, made, progress);
  Anatomy anatomy = std::move(made.anatomy);
  const bool stands_in = desc.shape.empty() && file.empty();
  const Pose pose = stands_in ? desc.pose * desc.fallback_pose : desc.pose;
  for (Vec3& x : anatomy.tets.positions) x = pose * x;
  apply_embedding(anatomy);
  return anatomy;
}

TriangleMesh make_surface(const RigidDesc& desc, const SourcePaths& paths, const Progress& progress) {
  const std::string& source = desc.volume.empty() ? desc.mesh : desc.volume;
  if (!desc.curves.empty() || !desc.patches.empty()) {
    TriangleMesh surface = mesh_of(desc.curves, desc.patches);
    say(progress, fmt::format("{}: {} triangles", desc.name, surface.triangles.size()));
    return surface;
  }
  if (source.empty() && desc.fallback.empty()) return mesh_of(desc.parts);
  const auto file =
      source.empty() ? std::filesystem::path{} : resolve(desc.name, source, desc.fallback, paths, progress);
  if (file.empty()) {
    const double cell = desc.surface_cell > 0 ? desc.surface_cell : desc.size.minCoeff() / 20;
    TriangleMesh surface =
        of_body(desc.name, [&] { return isosurface(implicit_shape(desc.fallback, desc.size), cell); });
    for (Vec3& x : surface.positions) x = desc.fallback_pose * x;
    return surface;
  }
  const ContentHash key =
      hash_of(fmt::format("rigid {} {} {} {} {} {} {} {}", recipe, file_hash(file), desc.volume.empty(),
                          desc.label, desc.threshold, desc.smoothing, desc.scale, desc.surface_cell));
  CachedAnatomy made;
  auto cached = take_cached(desc.name, paths, key, progress);
  if (cached) {
    made = std::move(*cached);
  } else {
    made = of_body(desc.name, [&] { return build(desc, file, progress); });
    store_cached(paths.cache_dir, key, made);
  }
  say(progress, fmt::format("{}: {} triangles{}", desc.name, made.anatomy.surface.triangles.size(),
                            cached ? " (cached)" : ""));
  warn(desc.name, made, progress);
  return std::move(made.anatomy.surface);
}

}  // namespace prosector
