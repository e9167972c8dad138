#include "common/anatomy/atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "common/anatomy/volume_io.h"
#include "common/error.h"
#include "common/scene/label_table.h"
#include "common/scene/material.h"
#include "common/scene/suggest.h"
#include "common/scene_messages.h"

namespace prosector {
namespace {

constexpr float max_label = 65535;
constexpr double small_cell_ratio =
    0.3;  // small structures: cell size over the edge of a cube of equal volume
constexpr double thin_cell_ratio = 1.1;  // thin structures: cell size over thickness
constexpr double largest_cell = 9e-3;    // m
constexpr double finest_cell = 5e-4;     // m: as in [[soft]]

/// Returns the area (m²) of each label's voxel faces towards other labels. For a smooth body it is about 3/2
/// of the surface area.
std::map<int, double> count_faces(const Volume& volume) {
  std::map<int, double> out;
  std::int64_t stride = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int k = static_cast<int>(axis);
    const double area = volume.voxel_size[(k + 1) % 3] * volume.voxel_size[(k + 2) % 3];
    const auto step = static_cast<std::size_t>(stride);
    for (std::size_t i = step; i < volume.values.size(); ++i) {
      const float a = volume.values[i - step], b = volume.values[i];
      if (a == b) continue;
      if (a > 0) out[static_cast<int>(a)] += area;
      if (b > 0) out[static_cast<int>(b)] += area;
    }
    stride *= volume.dims[axis];
  }
  return out;
}

/// Converts one atlas to bodies.
class AtlasReader {
 public:
  AtlasReader(const AtlasDesc& atlas, std::string where, const SourcePaths& paths)
      : atlas_(atlas), where_(std::move(where)), volume_(load_volume(find(atlas.volume, paths))) {
    voxels_ = count_labels(volume_, fmt::format("{}: {}", where_, atlas.volume));
    faces_ = count_faces(volume_);
    if (!atlas.labels.empty())
      table_ = load_labels(find(atlas.labels, paths));
    else
      for (const auto& [id, voxels] : voxels_)
        table_.labels.push_back(
            {.id = id, .name = fmt::format("region {}", id), .names = {}, .term = {}, .color = {}});
    check_lists();
  }

  /// Adds the bodies to the scene, and reports the structures that are omitted.
  void add_to(SceneDesc& scene, const Progress& progress) const {
    for (const std::string& note : volume_.notes)
      if (progress) progress(fmt::format("{}: {}: {}", where_, atlas_.volume, note));
    std::vector<const Label*> taken;
    for (const Label& label : table_.labels)
      if (wanted(label) && has(label) && !is_noise(label)) taken.push_back(&label);
    if (taken.empty())
      throw InputError(fmt::format("{}: no label remains; {} has {}", where_, atlas_.volume, listed()));
    for (std::size_t i = 0; i < taken.size(); ++i)
      add_body(*taken[i], hue(static_cast<double>(i) / static_cast<double>(taken.size())), scene);
    for (const Label& label : table_.labels)
      if (progress && wanted(label) && is_noise(label))
        progress(
            fmt::format("{}: label {} (\"{}\") has only {} voxels: omitted; list it in `only` to include it",
                        where_, label.id, label.name, voxels_.at(label.id)));
    const auto unnamed = std::ranges::count_if(
        voxels_, [&](const auto& entry) { return table_.find(entry.first) == nullptr; });
    if (progress)
      progress(fmt::format(
          "{}: {} of {} labels of {}{}", where_, taken.size(), voxels_.size(), atlas_.volume,
          unnamed > 0 ? fmt::format("; the table {} has no name for {} of the labels", atlas_.labels, unnamed)
                      : ""));
  }

 private:
  std::filesystem::path find(const std::string& file, const SourcePaths& paths) const {
    const auto found = find_source(file, paths);
    if (found.empty()) throw InputError(fmt::format("{}: {}", where_, missing_source(file, paths)));
    return found;
  }

  bool has(const Label& label) const { return voxels_.contains(label.id); }
  /// Returns whether the structure is too small to be taken without being named in `only`.
  bool is_noise(const Label& label) const {
    return has(label) && atlas_.only.empty() && voxels_.at(label.id) < min_structure_voxels;
  }

  bool wanted(const Label& label) const {
    const auto in = [&](const std::vector<std::string>& list) {
      return std::ranges::find(list, label.name) != list.end();
    };
    return (atlas_.only.empty() || in(atlas_.only)) && !in(atlas_.leave_out);
  }

  void check_lists() const {
    std::vector<std::string_view> known;
    for (const Label& label : table_.labels) {
      known.push_back(label.name);
      if (label.id == 0)
        throw InputError(
            fmt::format("{}: {}: label \"{}\" has no id; a label map's table needs a column \"id\"", where_,
                        table_.file, label.name));
    }
    const auto check = [&](const char* key, const std::vector<std::string>& list) {
      for (const std::string& name : list) {
        const Label* label = table_.find(name);
        if (label == nullptr)
          throw InputError(fmt::format("{}: {}: \"{}\": no label of {} has this name{}", where_, key, name,
                                       atlas_.labels.empty() ? atlas_.volume : atlas_.labels,
                                       suggest(name, known)));
        if (!has(*label))
          throw InputError(
              fmt::format("{}: {}: label {} (\"{}\") does not occur in {}, which has the labels {}", where_,
                          key, label->id, name, atlas_.volume, listed()));
      }
    };
    check("only", atlas_.only);
    check("leave_out", atlas_.leave_out);
  }

  /// Returns the map's first labels as text.
  std::string listed() const {
    constexpr std::size_t shown = 12;
    if (voxels_.empty()) return "no label except 0";
    std::string out;
    std::size_t i = 0;
    for (const auto& [id, voxels] : voxels_) {
      if (i++ == shown) return out + fmt::format(" ... ({} labels)", voxels_.size());
      out += fmt::format("{}{}", out.empty() ? "" : ", ", id);
    }
    return out;
  }

  static Vec3 hue(double turn) {  // of a colour wheel, slightly desaturated
    Vec3 out;
    for (int k = 0; k < 3; ++k) {
      const double sixths_away = std::abs(std::remainder(6 * (turn - k / 3.), 6));
      out[k] = 0.27 + 0.33 * std::clamp(2 - sixths_away, 0., 1.);
    }
    return out;
  }

  const Material& material(const Label& label) const {
    const Material* given = find_material(atlas_.material);
    return given != nullptr ? *given : material_for_part(label.name);
  }

  double cell(const Label& label) const {
    if (atlas_.cell > 0) return atlas_.cell;
    const double volume = static_cast<double>(voxels_.at(label.id)) * volume_.voxel_size.prod();
    const auto faces = faces_.find(label.id);  // none: the structure fills the map
    const double thickness = faces == faces_.end() ? largest_cell : 3 * volume / faces->second;
    return std::clamp(std::min(small_cell_ratio * std::cbrt(volume), thin_cell_ratio * thickness),
                      finest_cell, largest_cell);
  }

  void add_body(const Label& label, const Vec3& wheel, SceneDesc& scene) const {
    const Material& made_of = material(label);
    const bool says_nothing = made_of.name == materials().back().name || atlas_.material == made_of.name;
    const Vec3 color = label.color ? *label.color : says_nothing ? wheel : made_of.color;
    if (made_of.rigid) {
      RigidDesc& body = scene.rigid.emplace_back();
      describe(label, made_of, color, body);
      body.geometry.surface_cell = atlas_.surface_cell;
      return;
    }
    SoftDesc& body = scene.soft.emplace_back();
    describe(label, made_of, color, body);
    body.geometry.cell = cell(label);
    body.geometry.surface_cell = atlas_.surface_cell;
    body.configuration.model = atlas_.model;
    body.configuration.element = atlas_.element;
    body.configuration.integrator = atlas_.integrator;
    body.configuration.solver = atlas_.solver;
    body.material.damping_mass = atlas_.damping_mass;
    body.gravity = atlas_.gravity;
    if (atlas_.hold > 0) body.attach = {{atlas_.pose.p, reach(), atlas_.hold}};
  }

  template <class Desc>
  void describe(const Label& label, const Material& made_of, const Vec3& color, Desc& body) const {
    body.name = label.name;
    body.names = label.names;
    body.term = label.term;
    body.geometry.volume = atlas_.volume;
    body.geometry.label = label.id;
    body.geometry.smoothing = atlas_.smoothing;
    body.geometry.max_volume_error = atlas_.max_volume_error;
    body.pose = atlas_.pose;
    body.part = true;
    body.from_atlas = true;
    body.contact.group = atlas_.group;
    body.contact.touches = atlas_.touches;
    apply_material(made_of, body);
    body.appearance.color = color;
  }

  /// Returns the radius of a ball that contains the whole map, m.
  double reach() const {
    const auto& d = volume_.dims;
    return 0.5 * Vec3(static_cast<double>(d[0]), static_cast<double>(d[1]), static_cast<double>(d[2]))
                     .cwiseProduct(volume_.voxel_size)
                     .norm();
  }

  const AtlasDesc& atlas_;
  std::string where_;
  Volume volume_;
  std::map<int, std::size_t> voxels_;  // voxels by label
  std::map<int, double> faces_;        // m² of voxel faces, by label
  LabelTable table_;
};

/// Throws InputError if the scene with its atlases' bodies is invalid as a whole.
void check_bodies(const SceneDesc& scene) {
  std::set<std::string_view> names;
  const auto check = [&](const std::string& name) {
    if (!names.insert(name).second)
      throw InputError(
          fmt::format("{}: [[atlas]]: label \"{}\": another body has this name; names must differ",
                      scene.file.string(), name));
  };
  for (const RigidDesc& body : scene.rigid) check(body.name);
  for (const SoftDesc& body : scene.soft) check(body.name);
  if (names.size() > max_bodies)
    throw InputError(
        fmt::format("{}: the scene has {} bodies, those of its atlases included: at most {} are allowed; "
                    "list fewer labels in `only`",
                    scene.file.string(), names.size(), max_bodies));
}

template <class Desc>
void name_bodies(std::vector<Desc>& bodies, const LabelTable& table) {
  for (Desc& body : bodies)
    if (const Label* label = table.find(body.name); label != nullptr && body.names.empty()) {
      body.names = label->names;
      body.term = label->term;
    }
}

}  // namespace

std::map<int, std::size_t> count_labels(const Volume& volume, const std::string& where) {
  std::map<int, std::size_t> out;
  std::size_t run = 0;
  for (std::size_t i = 0; i < volume.values.size(); i += run) {
    const float value = volume.values[i];
    for (run = 1; i + run < volume.values.size() && volume.values[i + run] == value;) ++run;
    if (!(value >= 0 && value <= max_label && value == std::floor(value)))
      throw InputError(fmt::format("{}: not a label map: voxel {} is {}; allowed: whole numbers in [0, {}]",
                                   where, i, value, max_label));
    if (value > 0) out[static_cast<int>(value)] += run;
  }
  return out;
}

SceneDesc completed(SceneDesc scene, const SourcePaths& paths, const Progress& progress) {
  if (!scene.atlases.empty()) {
    for (std::size_t i = 0; i < scene.atlases.size(); ++i)
      AtlasReader(scene.atlases[i], fmt::format("{}: [[atlas]] {}", scene.file.string(), i + 1), paths)
          .add_to(scene, progress);
    scene.atlases.clear();
    check_bodies(scene);
  }
  if (scene.labels.empty()) return scene;
  if (const auto file = find_source(scene.labels, paths); !file.empty()) {
    const LabelTable table = load_labels(file);
    name_bodies(scene.rigid, table);
    name_bodies(scene.soft, table);
  } else if (progress) {
    progress(fmt::format("body names must differ: {}", missing_source(scene.labels, paths)));
  }
  scene.labels.clear();
  return scene;
}

}  // namespace prosector
