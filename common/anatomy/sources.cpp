#include "common/anatomy/sources.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <span>

#include "common/anatomy/anatomy_cache.h"
#include "common/anatomy/bytes.h"
#include "common/anatomy/embedding.h"
#include "common/anatomy/implicit.h"
#include "common/anatomy/isosurface.h"
#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/midpoint_subdivided.h"
#include "common/anatomy/sheets_and_ropes.h"
#include "common/anatomy/simplify.h"
#include "common/anatomy/stuffing.h"
#include "common/anatomy/surface_check.h"
#include "common/anatomy/surface_field.h"
#include "common/anatomy/surface_io.h"
#include "common/anatomy/surface_repair.h"
#include "common/anatomy/tet_io.h"
#include "common/anatomy/tet_repair.h"
#include "common/anatomy/volume_check.h"
#include "common/anatomy/volume_io.h"
#include "common/error.h"
#include "common/scene/primitives.h"
#include "common/scene/scene_curves.h"
#include "common/surface_files.h"

namespace prosector {
namespace {

constexpr int recipe = 4;  // increase when a source gives a different mesh: invalidates the cache

void say(const Progress& progress, const std::string& line) {
  if (progress) progress(line);
}

/// Returns the file in the first directory that has it. If it is missing, returns an empty path and reports
/// the fallback; throws InputError if there is none.
std::filesystem::path resolve(const std::string& body, const std::string& file, const std::string& fallback,
                              const SourcePaths& paths, const Progress& progress) {
  if (auto found = find_source(file, paths); !found.empty()) return found;
  if (fallback.empty())
    throw InputError(fmt::format("{}: {}, or set a fallback shape", body, missing_source(file, paths)));
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

std::string origin_key(const Vec3& origin) {
  return fmt::format(" {} {} {}", origin[0], origin[1], origin[2]);
}

/// Returns the result of `make()`; prefixes the message of an InputError with the body's name.
template <class Make>
auto with_body_name(const std::string& name, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", name, error.what()));
  }
}

CachedAnatomy mesh_solid(const std::string& name, const SolidField& field, const SoftDesc& desc,
                         const Progress& progress) {
  constexpr double takes_a_while = 2e5;  // tetrahedra
  if (const double tets = expected_tets(field, desc.geometry.cell); tets > takes_a_while && tets < max_tets)
    say(progress, fmt::format("{}: meshing with about {:.2g} tetrahedra, which takes a while; Ctrl-C cancels",
                              name, tets));
  TetMesh tets = stuff_solid(field, desc.geometry.cell);
  say(progress, fmt::format("{}: {}", name, describe(tet_quality(tets))));
  Embedding embedded = embed(std::move(tets), isosurface(field, desc.geometry.surface_cell));
  const Anatomy& a = embedded.anatomy;
  say(progress,
      fmt::format("{}: the surface has {} triangles; {} of its {} vertices are outside the tetrahedra", name,
                  a.surface.triangles.size(), embedded.outside, a.surface.positions.size()));
  CachedAnatomy out;
  if (embedded.drawn_in > 0)
    out.remarks.push_back(
        fmt::format("warning: cell is too coarse for the shape's thin parts: {} surface vertices moved "
                    "inward by up to {:.2g} mm",
                    embedded.drawn_in, 1000 * embedded.farthest));
  out.anatomy = std::move(embedded.anatomy);
  return out;
}

/// One structure of a volume file.
struct Structure {
  SolidField field;
  double volume = 0;  // m³: of all voxels of the label; grey-value volumes: of the largest piece
  double voxel = 0;   // m: the longest side of a voxel
  std::vector<std::string> remarks;
};

/// Extracts the structure of a SoftDesc or a RigidDesc.
template <class Desc>
Structure structure_of(const std::filesystem::path& file, const Desc& desc, const Progress& progress) {
  const auto& keys = desc.geometry;
  const Volume volume = load_volume(file);
  const std::string name = file.string();
  const int margin = smoothing_margin(keys.smoothing);
  const bool labelled = keys.label >= 0;
  const Mask mask = labelled ? mask_of_label(volume, keys.label, margin, name)
                             : mask_above(volume, keys.threshold, margin, name);
  if (mask.dropped_pieces > 0)
    say(progress, fmt::format("{}: only the largest of {} separate pieces is used ({} voxels dropped)",
                              desc.name, mask.dropped_pieces + 1, mask.dropped_voxels));
  if (mask.filled_voxels > 0)
    say(progress, fmt::format("{}: {} voxels of cavities filled", desc.name, mask.filled_voxels));
  const double voxel = volume.voxel_size.prod();
  const double of_label = mask.inside_volume() + voxel * (static_cast<double>(mask.dropped_voxels) -
                                                          static_cast<double>(mask.filled_voxels));
  return {smooth_solid(mask, keys.smoothing), labelled ? of_label : mask.inside_volume(),
          volume.voxel_size.maxCoeff(), desc.from_atlas ? std::vector<std::string>() : volume.notes};
}

// Whether the surface of a mesh file needs a vertex on each edge, since quadratic elements have a node there.
// A load on the corner nodes alone doesn't suit them.
bool needs_edge_vertices(const SoftDesc& desc) {
  return desc.configuration.is_quadratic();
}

void add(std::vector<std::string>& all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

Sign sign_for(const SolidShells& shells, std::size_t crossings) {
  return shells.simple && crossings == 0 ? Sign::nearest : Sign::winding;
}

/// Returns the volume inside a closed surface (m³), counting overlaps once.
double volume_within(const SolidShells& shells, std::size_t crossings) {
  constexpr int samples = 48;
  if (crossings > 0 || shells.overlapping)
    return sampled_volume(solid_within(shells.surface, Sign::winding), samples);
  return std::accumulate(shells.solids.begin(), shells.solids.end(), 0.);
}

void warn_of_crossings(std::size_t pairs, std::vector<std::string>& remarks) {
  if (pairs > 0)
    remarks.push_back(fmt::format(
        "warning: its surface intersects itself: {} pairs of triangles cross. Correct it in a mesh editor",
        pairs));
}

// Reads a tetrahedral mesh file; the surface is the mesh's boundary.
CachedAnatomy mesh_file(const std::filesystem::path& file, const SoftDesc& desc, const Progress& progress) {
  CachedAnatomy out;
  TetMesh tets = load_tets(file, desc.geometry.scale,
                           {.origin = desc.geometry.mesh_origin,
                            .report = [&](const std::string& line) { out.remarks.push_back(line); }});
  say(progress, fmt::format("{}: {}", desc.name, describe(tet_quality(tets))));
  const TetOverlap tangles = find_tet_overlap(tets);
  if (tangles.tets > 0)
    out.remarks.push_back(fmt::format(
        "warning: {} tetrahedra overlap: they are on the wrong side of a neighbour. Mesh it again",
        tangles.tets));
  TriangleMesh surface{tets.positions, boundary_faces(tets)};
  drop_unused(surface);
  const SurfaceReport report = check_surface(surface);
  if (const std::string warning = report.warning(); !warning.empty())
    out.remarks.push_back("warning: " + warning);
  out.expected_volume = tangles.enclosed;
  if (report.intersecting_pairs > 0 && !surface_faults(surface))
    out.expected_volume = volume_within(solid_shells(surface), report.intersecting_pairs);
  if (needs_edge_vertices(desc)) surface = midpoint_subdivided(std::move(surface));
  out.anatomy = embed(std::move(tets), std::move(surface)).anatomy;
  return out;
}

/// Meshes the solid inside a closed surface file.
CachedAnatomy fill_surface(const std::filesystem::path& file, const SoftDesc& desc,
                           const Progress& progress) {
  std::vector<std::string> remarks;
  RepairedSurface whole =
      repaired(load_surface(file, desc.geometry.scale,
                            {.origin = desc.geometry.mesh_origin,
                             .report = [&](const std::string& line) { remarks.push_back(line); }}));
  add(remarks, whole.notes);
  if (const SurfaceFaults faults = surface_faults(whole.surface))
    throw InputError(fmt::format("{}: {}", file.string(), faults.in_words()));
  SolidShells shells = solid_shells(whole.surface);
  add(remarks, shells.notes);
  const std::size_t crossings = intersecting_triangles(shells.surface).size();
  const double volume = volume_within(shells, crossings);
  if (shells.solids.size() > 1 && crossings == 0 && !shells.overlapping)
    remarks.push_back(
        fmt::format("{} separate solids in the file: the largest is used, {:.4g} of {:.4g} ml. A body is one "
                    "piece: write each solid to its own file",
                    shells.solids.size(), 1e6 * shells.solids.front(), 1e6 * volume));
  const Sign sign = sign_for(shells, crossings);
  CachedAnatomy out = mesh_solid(desc.name, solid_within(std::move(shells.surface), sign), desc, progress);
  out.remarks.insert(out.remarks.begin(), remarks.begin(), remarks.end());
  warn_of_crossings(crossings, out.remarks);
  out.expected_volume = volume;
  return out;
}

CachedAnatomy build(const SoftDesc& desc, const std::filesystem::path& file, const std::string& shape,
                    const Progress& progress) {
  if (!shape.empty()) return mesh_solid(desc.name, implicit_shape(shape, desc.geometry.size), desc, progress);
  if (is_surface_file(desc.geometry.mesh)) return fill_surface(file, desc, progress);
  if (desc.geometry.volume.empty()) return mesh_file(file, desc, progress);
  const Structure structure = structure_of(file, desc, progress);
  CachedAnatomy out = mesh_solid(desc.name, structure.field, desc, progress);
  add(out.remarks, structure.remarks);
  out.expected_volume = structure.volume;
  return out;
}

/// Reads a rigid body's surface, open or closed. For a closed one, the expected volume is that of its solids.
CachedAnatomy read_surface(const std::filesystem::path& file, const RigidDesc& desc) {
  CachedAnatomy out;
  RepairedSurface whole =
      repaired(load_surface(file, desc.geometry.scale,
                            {.origin = desc.geometry.mesh_origin,
                             .report = [&](const std::string& line) { out.remarks.push_back(line); }}));
  TriangleMesh& surface = out.anatomy.surface;
  surface = std::move(whole.surface);
  if (!surface_faults(surface)) {
    add(out.remarks, whole.notes);
    const std::size_t crossings = intersecting_triangles(surface).size();
    out.expected_volume = volume_within(solid_shells(surface), crossings);
  }
  if (desc.geometry.surface_cell > 0) surface = simplify(surface, desc.geometry.surface_cell);
  return out;
}

CachedAnatomy build(const RigidDesc& desc, const std::filesystem::path& file, const Progress& progress) {
  CachedAnatomy made;
  TriangleMesh& surface = made.anatomy.surface;
  if (desc.geometry.volume.empty()) {
    made = read_surface(file, desc);
  } else {
    const Structure structure = structure_of(file, desc, progress);
    surface = isosurface(structure.field,
                         desc.geometry.surface_cell > 0 ? desc.geometry.surface_cell : structure.voxel);
    made.remarks = structure.remarks;
    made.expected_volume = structure.volume;
  }
  const SurfaceReport report = check_surface(surface);
  if (const std::string warning = report.warning(); !warning.empty())
    made.remarks.push_back("warning: " + warning);
  if (report.volume < 0)
    for (auto& t : surface.triangles) std::swap(t[1], t[2]);
  return made;
}

/// Makes a sheet or rope, straight or along the curve or patch in the scene.
Anatomy make_fabric(const SoftDesc& desc) {
  if (desc.geometry.is_rope() && !desc.geometry.curves.empty())
    return make_rope(make_curve(desc.geometry.curves.front()), desc.geometry.curves.front().diameter,
                     desc.geometry.cell);
  if (desc.geometry.is_rope()) return make_rope(desc.geometry.size, desc.geometry.cell);
  if (!desc.geometry.patches.empty())
    return make_sheet(*make_patch(desc.geometry.patches.front()), desc.geometry.patches.front().thickness,
                      desc.geometry.cell);
  return make_sheet(desc.geometry.size, desc.geometry.cell);
}

void say_remarks(const std::string& name, const std::vector<std::string>& remarks, const Progress& progress) {
  for (const std::string& remark : remarks) say(progress, fmt::format("{}: {}", name, remark));
}

/// Reports the difference between a body's volume and its file's; throws InputError if it is too large.
/// `desc` is a SoftDesc or a RigidDesc.
template <class Desc>
void report_volume_error(const Desc& desc, double made, double expected, const Progress& progress) {
  const bool labelled = !desc.geometry.volume.empty();
  const std::string warning = with_body_name(desc.name, [&] {
    return check_volume(
        made, expected, desc.geometry.max_volume_error.value,
        labelled ? "of its voxels" : "that its file encloses",
        labelled ? "If a label has several pieces, the largest is used, and cavities are filled; thin parts "
                   "need a smaller cell, and parts as thin as a voxel need a finer volume."
                 : "A body is one piece: write separate solids to separate files; thin parts need a smaller "
                   "cell.");
  });
  if (!warning.empty()) say(progress, fmt::format("{}: {}", desc.name, warning));
}

/// Loads a mesh from the cache. Reports a damaged file and returns none, so that the mesh is rebuilt.
std::optional<CachedAnatomy> load_cached_mesh(const std::string& name, const SourcePaths& paths,
                                              const ContentHash& key, const Progress& progress) {
  CachedAnatomyResult found = load_cached(paths.cache_dir, key);
  if (!found.error.empty()) say(progress, fmt::format("{}: its cached mesh {}: rebuilt", name, found.error));
  return std::move(found.made);
}

}  // namespace

Anatomy make_anatomy(const SoftDesc& desc, const SourcePaths& paths, const Progress& progress) {
  if (!desc.geometry.is_solid()) {
    Anatomy made = with_body_name(desc.name, [&] { return make_fabric(desc); });
    for (Vec3& x : made.tets.positions) x = desc.pose * x;
    apply_embedding(made);
    return made;
  }
  std::string shape = desc.geometry.shape;
  std::filesystem::path file;
  if (shape.empty()) {
    const std::string& source = desc.geometry.volume.empty() ? desc.geometry.mesh : desc.geometry.volume;
    if (source.empty())
      throw InputError(
          fmt::format("{}: the body has no geometry; allowed: volume, mesh or shape", desc.name));
    file = resolve(desc.name, source, desc.geometry.fallback, paths, progress);
    if (file.empty()) shape = desc.geometry.fallback;
  }
  const std::string made_from = shape.empty() ? file_hash(file) : shape;
  const bool own_boundary =
      shape.empty() && desc.geometry.volume.empty() && !is_surface_file(desc.geometry.mesh);
  const ContentHash key = hash_of(fmt::format(
      "soft {} {} {} {} {} {} {} {} {} {} {} {}{}{}", recipe, made_from, desc.geometry.volume.empty(),
      desc.geometry.label, desc.geometry.threshold, desc.geometry.size[0], desc.geometry.size[1],
      desc.geometry.size[2], desc.geometry.scale, desc.geometry.cell, desc.geometry.surface_cell,
      desc.geometry.smoothing, own_boundary && needs_edge_vertices(desc) ? " halved edges" : "",
      origin_key(desc.geometry.mesh_origin)));
  CachedAnatomy made;
  if (auto cached = load_cached_mesh(desc.name, paths, key, progress)) {
    made = std::move(*cached);
    say(progress, fmt::format("{}: {} (cached)", desc.name, describe(tet_quality(made.anatomy.tets))));
  } else {
    made = with_body_name(desc.name, [&] { return build(desc, file, shape, progress); });
    store_cached(paths.cache_dir, key, made);
  }
  say_remarks(desc.name, made.remarks, progress);
  report_volume_error(desc, tet_quality(made.anatomy.tets).volume, made.expected_volume, progress);
  Anatomy anatomy = std::move(made.anatomy);
  const bool stands_in = desc.geometry.shape.empty() && file.empty();
  const Pose pose = stands_in ? desc.pose * desc.geometry.fallback_pose : desc.pose;
  for (Vec3& x : anatomy.tets.positions) x = pose * x;
  apply_embedding(anatomy);
  return anatomy;
}

TriangleMesh make_surface(const RigidDesc& desc, const SourcePaths& paths, const Progress& progress) {
  const std::string& source = desc.geometry.volume.empty() ? desc.geometry.mesh : desc.geometry.volume;
  if (!desc.geometry.curves.empty() || !desc.geometry.patches.empty()) {
    TriangleMesh surface = mesh_of(desc.geometry.curves, desc.geometry.patches);
    say(progress, fmt::format("{}: {} triangles", desc.name, surface.triangles.size()));
    return surface;
  }
  if (source.empty() && desc.geometry.fallback.empty()) return mesh_of(desc.geometry.parts);
  const auto file = source.empty() ? std::filesystem::path{}
                                   : resolve(desc.name, source, desc.geometry.fallback, paths, progress);
  if (file.empty()) {
    const double cell =
        desc.geometry.surface_cell > 0 ? desc.geometry.surface_cell : desc.geometry.size.minCoeff() / 20;
    TriangleMesh surface = with_body_name(desc.name, [&] {
      return isosurface(implicit_shape(desc.geometry.fallback, desc.geometry.size), cell);
    });
    for (Vec3& x : surface.positions) x = desc.geometry.fallback_pose * x;
    return surface;
  }
  const ContentHash key = hash_of(
      fmt::format("rigid {} {} {} {} {} {} {} {}{}", recipe, file_hash(file), desc.geometry.volume.empty(),
                  desc.geometry.label, desc.geometry.threshold, desc.geometry.smoothing, desc.geometry.scale,
                  desc.geometry.surface_cell, origin_key(desc.geometry.mesh_origin)));
  CachedAnatomy made;
  auto cached = load_cached_mesh(desc.name, paths, key, progress);
  if (cached) {
    made = std::move(*cached);
  } else {
    made = with_body_name(desc.name, [&] { return build(desc, file, progress); });
    store_cached(paths.cache_dir, key, made);
  }
  say(progress, fmt::format("{}: {} triangles{}", desc.name, made.anatomy.surface.triangles.size(),
                            cached ? " (cached)" : ""));
  say_remarks(desc.name, made.remarks, progress);
  if (made.expected_volume > 0)
    report_volume_error(desc, std::abs(enclosed_volume(made.anatomy.surface)), made.expected_volume,
                        progress);
  return std::move(made.anatomy.surface);
}

}  // namespace prosector
