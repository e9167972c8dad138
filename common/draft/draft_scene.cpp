#include "common/draft/draft_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "common/anatomy/atlas.h"
#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/simplify.h"
#include "common/anatomy/surface_field.h"
#include "common/anatomy/surface_io.h"
#include "common/anatomy/surface_repair.h"
#include "common/anatomy/tet_io.h"
#include "common/anatomy/volume_check.h"
#include "common/anatomy/volume_io.h"
#include "common/draft/setting.h"
#include "common/draft/toml_text.h"
#include "common/error.h"
#include "common/file_endings.h"
#include "common/ids.h"
#include "common/regular_file.h"
#include "common/scene/label_table.h"
#include "common/scene/load_scene.h"
#include "common/scene/material.h"
#include "common/scene_messages.h"
#include "common/surface_files.h"
#include "common/valid_text.h"

namespace prosector {
namespace {

constexpr double tets_of_all = 8000, least_tets = 300, most_tets = 4000;  // all bodies; one body
constexpr double tet_share = 0.128;  // volume of a tetrahedron over the cube of its cell
constexpr double finest_cell = 1e-3, coarsest_cell = 0.05;  // m
constexpr double least_size = 1e-3, most_size = 10;         // m
constexpr double drawn_toughness = 10;  // J/m²: low, so that a drawn blade cuts tissue that is not held taut
constexpr double hold = 2e5;  // N/m⁴: stiffness of the springs that hold an organ in place, as in [[atlas]]
constexpr std::array<std::string_view, 2> tet_endings = {".msh", ".vtk"};

struct Unit {
  const char* name;
  const char* flag;
  double metres;
};
constexpr std::array<Unit, 3> units = {
    {{"millimetres", "mm", 1e-3}, {"centimetres", "cm", 1e-2}, {"metres", "m", 1}}};

/// One surface or tetrahedral mesh file and its properties.
struct Part {
  std::filesystem::path file;
  std::string name;
  const Material* material = nullptr;
  bool rigid = false;
  std::size_t tets = 0;  // number of tetrahedra in the file; 0: a surface
  TriangleMesh surface;  // file units; boundary surface of a tetrahedral mesh
  Eigen::AlignedBox3d box;
  double volume = 0;               // file units: volume of the soft body's solids
  std::vector<std::string> notes;  // on how the file was read
};

Eigen::AlignedBox3d box_of(const TriangleMesh& surface, const Pose& pose, double unit) {
  Eigen::AlignedBox3d out;
  for (const Vec3& x : surface.positions) out.extend(pose * (unit * x));
  return out;
}

/// Returns the path of the file in the scene: relative to `folder`, or absolute if the file is elsewhere.
std::string path_in_scene(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const auto whole = std::filesystem::weakly_canonical(file);
  const auto relative = whole.lexically_relative(std::filesystem::weakly_canonical(folder));
  return relative.empty() || relative.native().starts_with("..") ? whole.string() : relative.string();
}

std::string spaced_name(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  std::ranges::replace(name, '_', ' ');
  return name;
}

/// Returns the name of the body made from this file, cut to max_name_length.
std::string name_of(const std::filesystem::path& file) {
  std::string name = spaced_name(file);
  if (name.size() > max_name_length && valid_utf8(name)) {
    name.resize(max_name_length);
    while (!valid_utf8(name) || name.ends_with(' ')) name.pop_back();
  }
  if (!valid_name(name))
    throw InputError(
        fmt::format("{}: the file's name becomes the body's name, so it must have 1 to {} bytes of UTF-8",
                    file.string(), max_name_length));
  return name;
}

bool is_tet_file(const std::filesystem::path& file) {
  return has_ending(file.native(), tet_endings);
}

bool is_body_file(const std::filesystem::path& file) {
  return is_surface_file(file.string()) || is_tet_file(file);
}

std::vector<std::filesystem::path> bodies_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (const std::filesystem::path name = entry.path().filename();
        entry.is_regular_file() && is_body_file(name) && !name.native().starts_with('.'))
      out.push_back(entry.path());
  if (out.empty())
    throw InputError(
        fmt::format("{}: contains no surface or tetrahedral mesh; allowed: files that end in {} {}",
                    folder.string(), fmt::join(surface_endings, " "), fmt::join(tet_endings, " ")));
  if (out.size() >= max_bodies)
    throw InputError(
        fmt::format("{}: the folder has {} meshes, each of which would be a body; a scene may have {} bodies",
                    folder.string(), out.size(), max_bodies));
  std::ranges::sort(out);
  return out;
}

/// Finds the solid of a soft body. Throws InputError if the surface isn't closed, or if the largest of its
/// separate solids is too small a fraction.
void find_solid(Part& part) {
  if (const SurfaceFaults faults = surface_faults(part.surface))
    throw InputError(faults.in_words() + " (--rigid)");
  SolidShells shells = solid_shells(part.surface);
  part.notes.insert(part.notes.end(), shells.notes.begin(), shells.notes.end());
  part.surface = std::move(shells.surface);
  const double all = std::accumulate(shells.solids.begin(), shells.solids.end(), 0.);
  if (shells.solids.size() < 2 || shells.overlapping) {
    part.volume = all;
    return;
  }
  part.volume = shells.solids.front();
  const double left_out = 100 * (1 - part.volume / all);
  const std::string said = fmt::format(
      "contains {} separate solids, the largest with {:.3g} % of their volume. A body is one piece: write "
      "each to its own file",
      shells.solids.size(), 100 - left_out);
  if (left_out > accepted_volume_error) throw InputError(said + ", or make the body rigid (--rigid)");
  part.notes.push_back(said);
}

Part read_part(const std::filesystem::path& file, bool rigid) {
  Part out{.file = file, .name = name_of(file), .surface = {}, .box = {}, .notes = {}};
  const auto report = [&](const std::string& line) { out.notes.push_back(line); };
  if (is_tet_file(file)) {
    if (rigid)
      throw InputError(fmt::format("{}: --rigid is for surfaces; a tetrahedral mesh deforms", file.string()));
    const TetMesh mesh = load_tets(file, 1, {.report = report});
    out.tets = mesh.tets.size();
    out.surface = TriangleMesh{mesh.positions, boundary_faces(mesh)};
    drop_unused(out.surface);
    out.volume = std::abs(enclosed_volume(out.surface));
  } else {
    RepairedSurface whole = repaired(load_unscaled_surface(file, {.report = report}));
    out.notes.insert(out.notes.end(), whole.notes.begin(), whole.notes.end());
    out.surface = std::move(whole.surface);
  }
  if (const std::string full = spaced_name(file); full != out.name)
    out.notes.push_back(fmt::format("the body's name is longer than {} bytes: shortened to \"{}\"",
                                    max_name_length, out.name));
  out.material = &material_for_part(spaced_name(file));
  if (out.tets > 0 && out.material->rigid) out.material = &materials().back();  // it is soft
  out.rigid = rigid || out.material->rigid;
  if (!out.rigid && out.tets == 0) find_solid(out);
  out.box = box_of(out.surface, Pose{}, 1);
  return out;
}

/// Reads all files. Throws InputError with the reason for each file that can't be used.
std::vector<Part> read_parts(const std::vector<std::filesystem::path>& files, const DraftOptions& options) {
  std::vector<Part> out;
  std::string bad;
  std::set<std::string> names = {std::string(table_name)};
  if (options.scalpel) names.emplace(scalpel_name);
  const auto refuse = [&](const std::filesystem::path& file, const std::string& why) {
    const bool named = why.starts_with(file.string());
    bad += fmt::format("{}{}{}", bad.empty() ? "" : "\n", named ? "" : file.string() + ": ", why);
  };
  for (const auto& file : files) try {
      const std::string name = name_of(file);
      if (!names.insert(name).second)
        refuse(file, fmt::format("another body is called \"{}\"; names must differ{}", name,
                                 name == scalpel_name ? " (--no-scalpel)" : ""));
      out.push_back(read_part(file, options.rigid));
    } catch (const InputError& error) {
      refuse(file, error.what());
    }
  if (!bad.empty()) throw InputError(bad);
  return out;
}

std::string exact_numbers(const Vec3& x) {
  return fmt::format("[{}, {}, {}]", x[0], x[1], x[2]);
}

/// Returns the point that becomes the bodies' origin (file units): zero, or the centre of all bodies if they
/// are far from the files' origin.
Vec3 origin_for(const Eigen::AlignedBox3d& box, double unit, std::vector<std::string>& notes) {
  constexpr double far = 10;  // m
  if (unit * box.center().norm() <= far) return Vec3::Zero();
  const Vec3 out = box.center().array().round();
  notes.push_back(
      fmt::format("the mesh is {:.4g} m from the origin of the file, so the scene has mesh_origin = {}",
                  unit * box.center().norm(), exact_numbers(out)));
  return out;
}

double unit_of(const std::vector<Part>& parts, const DraftOptions& options, std::vector<std::string>& notes) {
  double unit = options.unit.value_or(0);
  Eigen::AlignedBox3d all;
  std::vector<double> usual, extents;
  for (const Part& part : parts) {
    all.extend(part.box);
    usual.push_back(part.material->usual_size);
    extents.push_back(part.box.sizes().maxCoeff());
  }
  if (!options.unit) unit = guess_unit(usual, extents);
  const auto known = std::ranges::find(units, unit, &Unit::metres);
  const Vec3 size = all.sizes();
  notes.push_back(fmt::format(
      "{:.4g} x {:.4g} x {:.4g} in the file{}: {} {}, {:.3g} m across{}", size[0], size[1], size[2],
      parts.size() > 1 ? "s" : "", options.unit ? "in" : "assumed to be",
      known == units.end() ? fmt::format("units of {} m", unit) : known->name, unit * size.maxCoeff(),
      options.unit ? "" : "; if the unit is wrong, set it: --unit mm, cm or m"));
  const double across = unit * size.maxCoeff();
  if (!(across >= least_size && across <= most_size))
    throw InputError(fmt::format("the bodies are {} m across; allowed: {} to {} m; choose --unit mm, cm or m",
                                 across, least_size, most_size));
  return unit;
}

/// Returns the cell size (m) for a solid of this volume (m³) and surface area (m²).
double cell_for(double volume, double area, double tets) {
  const double by_count = std::cbrt(volume / (tet_share * tets));
  const double thickness = 2 * volume / area;
  return std::clamp(std::min(by_count, thickness), finest_cell, coarsest_cell);
}

double area_of(const TriangleMesh& surface) {
  double out = 0;
  for (const auto& t : surface.triangles)
    out += 0.5 * (surface.positions[t[1]] - surface.positions[t[0]])
                     .cross(surface.positions[t[2]] - surface.positions[t[0]])
                     .norm();
  return out;
}

std::string rotation_text(bool z_up) {
  return z_up ? "rotation = [0.70710678, -0.70710678, 0, 0]  # the file's z is up\n" : "";
}

Quat rotation(bool z_up) {
  return z_up ? Quat(0.70710678, -0.70710678, 0, 0).normalized() : Quat::Identity();
}

std::string head(const std::string& name, const std::string& description) {
  return fmt::format("name = {}\ndescription = {}\n\n", toml_text(name), toml_text(description));
}

/// Returns the TOML keys that rigid and soft bodies from a surface file share.
template <class Desc>
std::string body_text(const char* table, const Part& part, double unit, const Vec3& origin, const Pose& pose,
                      bool z_up, const std::filesystem::path& folder) {
  Desc desc;
  apply_material(*part.material, desc);
  return fmt::format(
      "\n[[{}]]\nname = {}\nmesh = {}\nscale = {}\n{}position = {}\n{}anatomy = true\ngroup = \"anatomy\"  # "
      "adjacent bodies of this group need no contacts with each other\ntouches = [\"default\", "
      "\"hand\"]\ndensity = {}\nsurface = \"{}\"\ncolor = {}\nwetness = {}\n",
      table, toml_text(part.name), toml_text(path_in_scene(part.file, folder)), toml_number(unit),
      origin.isZero() ? "" : fmt::format("mesh_origin = {}\n", exact_numbers(origin)), toml_numbers(pose.p),
      rotation_text(z_up), toml_number(desc.material.density), part.material->rigid ? "bone" : "tissue",
      toml_numbers(desc.appearance.color), toml_number(desc.appearance.wetness));
}

std::string soft_text(const Part& part, double unit, const Pose& pose, double tets,
                      std::vector<std::string>& notes) {
  SoftDesc desc;
  apply_material(*part.material, desc);
  const double volume = part.volume * unit * unit * unit;
  const double cell = cell_for(volume, area_of(part.surface) * unit * unit, tets);
  const Eigen::AlignedBox3d box = box_of(part.surface, pose, unit);
  notes.push_back(
      fmt::format("{}: {:.4g} ml of {}{}, {}", part.name, 1e6 * volume, part.material->name,
                  part.material == &materials().back() ? " (its name contains no known material)" : "",
                  part.tets > 0 ? fmt::format("{} tetrahedra as in the file", part.tets)
                                : fmt::format("cell {:.2g} mm", 1e3 * cell)));
  const std::string cells = part.tets > 0 ? ""
                                          : fmt::format("cell = {}\nsurface_cell = {}\n", toml_number(cell),
                                                        toml_number(0.5 * cell));
  return fmt::format(
      "{}youngs_modulus = {}\ntoughness = {}  # J/m²: low enough for a drawn blade; of real tissue: "
      "{}\ndamping_mass = 4\ngravity = false  # the file's shape already carries its weight\n\n  "
      "[[soft.attach]]\n  center = {}\n  radius = {}\n  stiffness = {}\n",
      cells, toml_number(desc.material.youngs_modulus), toml_number(drawn_toughness),
      toml_number(desc.material.toughness), toml_numbers(box.center()),
      toml_number(0.55 * box.sizes().norm()), toml_number(hold));
}

/// Adds a scalpel next to the bodies, unless disabled.
void add_scalpel(const Eigen::AlignedBox3d& box, const DraftOptions& options, Draft& out) {
  if (!options.scalpel) return;
  out.toml += scalpel_toml(box);
  out.notes.emplace_back(
      "a scalpel was added on the table, to the right of the bodies (omit it with --no-scalpel)");
}

Draft draft_surfaces(const std::string& name, const std::vector<std::filesystem::path>& files,
                     const std::filesystem::path& folder, const DraftOptions& options) {
  Draft out;
  std::vector<Part> parts = read_parts(files, options);
  for (const Part& part : parts)
    for (const std::string& note : part.notes) out.notes.push_back(fmt::format("{}: {}", part.name, note));
  const double unit = unit_of(parts, options, out.notes);
  Eigen::AlignedBox3d in_files;
  for (const Part& part : parts) in_files.extend(part.box);
  const Vec3 origin = origin_for(in_files, unit, out.notes);
  for (Part& part : parts)
    for (Vec3& x : part.surface.positions) x -= origin;
  const bool z_up = options.z_up.value_or(false);
  Pose pose{Vec3::Zero(), rotation(z_up)};
  Eigen::AlignedBox3d box;
  for (const Part& part : parts) box.extend(box_of(part.surface, pose, unit));
  pose.p = shift_onto_table(box);
  box.translate(pose.p);
  const auto soft = static_cast<double>(std::ranges::count(parts, false, &Part::rigid));
  const double tets = std::clamp(tets_of_all / std::max(soft, 1.), least_tets, most_tets);
  out.toml = head(name, parts.size() == 1 ? "Drafted from " + files.front().filename().string()
                                          : fmt::format("Drafted from {} files", parts.size())) +
             setting_toml(box);
  for (const Part& part : parts) {
    if (part.rigid) {
      out.toml += body_text<RigidDesc>("rigid", part, unit, origin, pose, z_up, folder);
      out.notes.push_back(fmt::format("{}: rigid ({})", part.name, part.material->name));
    } else {
      out.toml += body_text<SoftDesc>("soft", part, unit, origin, pose, z_up, folder) +
                  soft_text(part, unit, pose, tets, out.notes);
    }
  }
  if (soft > 0) add_scalpel(box, options, out);
  return out;
}

/// Returns the label table of a label map: for map.nii.gz the first of map.nii.csv, map.nii.txt, map.csv,
/// map.txt that exists.
std::filesystem::path find_label_table(const std::filesystem::path& map) {
  std::filesystem::path stem = map;
  if (has_ending(stem.native(), ".gz")) stem.replace_extension();
  for (const auto& base : {stem, std::filesystem::path(stem).replace_extension()})
    for (const char* ending : {".csv", ".txt"})
      if (std::filesystem::path file = base.string() + ending; std::filesystem::is_regular_file(file))
        return file;
  return {};
}

/// Returns the fraction of x-neighbours, both labelled, that have different labels. It is low for label maps
/// and high for grey-value images.
double unequal_neighbour_fraction(const Volume& volume) {
  std::size_t pairs = 0, unlike = 0;
  for (std::size_t i = 1; i < volume.values.size(); ++i) {
    const float a = volume.values[i - 1], b = volume.values[i];
    if (a <= 0 || b <= 0) continue;
    ++pairs;
    unlike += a != b ? 1 : 0;
  }
  return pairs == 0 ? 0 : static_cast<double>(unlike) / static_cast<double>(pairs);
}

/// Returns the bounding box of all structures with at least min_structure_voxels voxels, in the volume's
/// frame (m).
Eigen::AlignedBox3d labelled_box(const Volume& volume, const std::map<int, std::size_t>& voxels) {
  std::set<float> labels;
  for (const auto& [label, count] : voxels)
    if (count >= min_structure_voxels) labels.insert(static_cast<float>(label));
  Eigen::AlignedBox3d out;
  std::size_t at = 0;
  for (std::int64_t k = 0; k < volume.dims[2]; ++k)
    for (std::int64_t j = 0; j < volume.dims[1]; ++j)
      for (std::int64_t i = 0; i < volume.dims[0]; ++i)
        if (const float label = volume.values[at++]; label > 0 && labels.contains(label))
          out.extend(
              volume.position({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)}));
  return out;
}

/// Returns the [patient] table as TOML for a volume with the axes right, anterior, superior, rotated by
/// `turn`.
std::string patient_of(const Quat& turn) {
  return fmt::format("\n[patient]\nright = {}\nhead = {}\n", toml_numbers(turn * Vec3::UnitX()),
                     toml_numbers(turn * Vec3::UnitZ()));
}

Draft draft_atlas(const std::string& name, const std::filesystem::path& map,
                  const std::filesystem::path& folder, const DraftOptions& options) {
  Draft out;
  const Volume volume = load_volume(map);
  out.notes = volume.notes;
  const auto voxels = count_labels(volume, map.string());
  const auto is_structure = [](const auto& entry) { return entry.second >= min_structure_voxels; };
  if (std::ranges::none_of(voxels, is_structure))
    throw InputError(
        fmt::format("{}: no label has {} voxels or more, so there is no structure that could be a body",
                    map.string(), min_structure_voxels));
  if (unequal_neighbour_fraction(volume) > 0.5)
    throw InputError(fmt::format(
        "{}: not a label map: most neighbouring voxels differ, as in grey values. Write a [[soft]] or "
        "[[rigid]] body with this volume and a threshold (docs/look-up/scene.md), or segment it first",
        map.string()));
  const auto labels = options.labels.empty() ? find_label_table(map) : options.labels;
  out.notes.push_back(
      labels.empty()
          ? fmt::format("{} labels, named by number: provide their names in a table (--labels FILE)",
                        voxels.size())
          : fmt::format("{} labels, names from {}", voxels.size(), labels.string()));
  if (!labels.empty()) (void)load_labels(labels);
  const bool z_up = options.z_up.value_or(true);
  Pose pose{Vec3::Zero(), rotation(z_up)};
  Eigen::AlignedBox3d box;
  const Eigen::AlignedBox3d in_volume = labelled_box(volume, voxels);
  for (int corner = 0; corner < 8; ++corner)
    box.extend(pose * Vec3(in_volume.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))));
  pose.p = shift_onto_table(box);
  box.translate(pose.p);
  out.toml = head(name, "Drafted from " + map.filename().string()) + setting_toml(box) +
             (volume.oriented ? patient_of(pose.q) : "") +
             fmt::format(
                 "\n[[atlas]]\nvolume = {}\n{}max_volume_error = \"40 %\"  # thin structures lose volume at "
                 "this cell; the server reports how much\nposition = {}\n{}",
                 toml_text(path_in_scene(map, folder)),
                 labels.empty() ? "" : fmt::format("labels = {}\n", toml_text(path_in_scene(labels, folder))),
                 toml_numbers(pose.p), rotation_text(z_up));
  add_scalpel(box, options, out);
  return out;
}

Draft draft(const std::filesystem::path& source, const std::filesystem::path& folder,
            const DraftOptions& options) {
  const std::filesystem::path whole = std::filesystem::weakly_canonical(source);
  if (std::filesystem::is_directory(source))
    return draft_surfaces(name_of(whole), bodies_in(source), folder, options);
  require_regular_file(source);
  if (!std::filesystem::exists(source))
    throw InputError(fmt::format("{}: no such file or folder", source.string()));
  if (is_body_file(source)) return draft_surfaces(name_of(whole), {source}, folder, options);
  if (has_ending(source.native(), volume_endings))
    return draft_atlas(name_of(std::filesystem::path(whole).replace_extension()), source, folder, options);
  throw InputError(
      fmt::format("{}: unsupported; allowed: a surface ({}), a tetrahedral mesh ({}), a folder of these, or "
                  "a label map ({})",
                  source.string(), fmt::join(surface_endings, " "), fmt::join(tet_endings, " "),
                  fmt::join(volume_endings, " ")));
}

}  // namespace

double guess_unit(const std::vector<double>& usual_sizes, const std::vector<double>& extents) {
  const auto off = [&](double metres) {
    double out = 0;
    for (std::size_t i = 0; i < extents.size(); ++i) out += std::log(metres * extents[i] / usual_sizes[i]);
    return std::abs(out);
  };
  return std::ranges::min_element(units, {}, [&](const Unit& unit) { return off(unit.metres); })->metres;
}

Draft draft_scene(const std::filesystem::path& source, const std::filesystem::path& folder,
                  const DraftOptions& options) {
  Draft out = draft(source, folder, options);
  parse_scene(out.toml, folder / "draft.toml");  // Check that the result is a valid scene.
  return out;
}

}  // namespace prosector
