#include "common/scene/scene_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "common/error.h"
#include "common/scene/scene_curves.h"
#include "common/scene/suggest.h"
#include "common/scene_messages.h"
#include "common/surface_files.h"

namespace prosector {
namespace {

constexpr double least_edge = 1e-4;  // m: minimum length of a blade's edge

/// A body of any kind, and its location in the scene file.
struct Entry {
  std::string table;        // "soft[0]"
  std::string where;        // [[soft]] "liver"
  const std::string* name;  // null: an atlas, which has many names
  const std::string* parent;
  const std::string* group;
  const std::vector<std::string>* touches;
};

class Checker {
 public:
  Checker(const SceneDesc& scene, const SourceLines& lines) : scene_(scene), lines_(lines) {
    add("rigid", scene.rigid);
    add("soft", scene.soft);
  }

  void run() const {
    if (bodies_.size() > max_bodies)
      fail("", "", "",
           fmt::format("the scene has {} bodies: at most {} are allowed", bodies_.size(), max_bodies));
    check_names();
    check_parents();
    check_groups();
    for (std::size_t i = 0; i < scene_.rigid.size(); ++i) check_rigid(scene_.rigid[i], bodies_[i]);
    for (std::size_t i = 0; i < scene_.soft.size(); ++i)
      check_soft(scene_.soft[i], bodies_[scene_.rigid.size() + i]);
    check_lights();
    if (scene_.camera.eye == scene_.camera.target)
      fail("camera", "target", "[camera]", "the camera's target must differ from eye");
    if (scene_.patient && !is_valid_patient_frame(*scene_.patient))
      fail("patient", "head", "[patient]",
           "the patient's directions right and head must be perpendicular and non-zero");
  }

 private:
  template <class Desc>
  void add(const std::string& key, const std::vector<Desc>& list) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto& groups = list[i].contact;
      bodies_.push_back({fmt::format("{}[{}]", key, i), fmt::format("[[{}]] \"{}\"", key, list[i].name),
                         &list[i].name, &list[i].parent, &groups.group, &groups.touches});
    }
  }

  [[noreturn]] void fail(const std::string& table, const std::string& key, const std::string& where,
                         const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}{}{}", scene_.file.string(), lines_.of(table, key), where,
                                 where.empty() ? "" : ": ", what));
  }
  [[noreturn]] void fail(const Entry& body, const std::string& key, const std::string& what) const {
    fail(body.table, key, body.where, what);
  }

  void check_names() const {
    std::map<std::string_view, const Entry*> seen;
    for (const Entry& body : bodies_) {
      const auto [first, fresh] = seen.emplace(*body.name, &body);
      if (!fresh)
        fail(body, "name",
             fmt::format("this name is already used by the body in line {}; names must differ",
                         lines_.of(first->second->table, "name")));
    }
  }

  void check_parents() const {
    std::map<std::string_view, const Entry*> by_name;
    std::vector<std::string_view> names;
    for (const Entry& body : bodies_) {
      by_name[*body.name] = &body;
      names.push_back(*body.name);
    }
    for (const Entry& body : bodies_) {
      if (!body.parent->empty() && !by_name.contains(*body.parent))
        fail(body, "parent",
             fmt::format("parent = \"{}\": no body has this name{}", *body.parent,
                         suggest(*body.parent, names)));
    }
    for (const Entry& body : bodies_) {
      const Entry* above = &body;
      for (std::size_t depth = 0; !above->parent->empty(); ++depth) {
        above = by_name.at(*above->parent);
        if (above == &body || depth > bodies_.size())
          fail(body, "parent",
               fmt::format("parent = \"{}\": a body can't be its own ancestor", *body.parent));
      }
    }
  }

  void check_groups() const {
    std::vector<Entry> all = bodies_;
    for (std::size_t i = 0; i < scene_.atlases.size(); ++i)
      all.push_back({fmt::format("atlas[{}]", i), fmt::format("[[atlas]] {}", i + 1), nullptr, nullptr,
                     &scene_.atlases[i].group, &scene_.atlases[i].touches});
    std::vector<std::string_view> groups = {default_group, hand_group};
    for (const Entry& body : all) {
      if (std::find(groups.begin(), groups.end(), *body.group) != groups.end()) continue;
      if (groups.size() == max_collision_groups)
        fail(
            body, "group",
            fmt::format(
                "group = \"{}\": {} collision groups exist already, {} and {} included, which is the maximum",
                *body.group, groups.size(), default_group, hand_group));
      groups.push_back(*body.group);
    }
    for (const Entry& body : all)
      for (const std::string& name : *body.touches)
        if (std::find(groups.begin(), groups.end(), name) == groups.end())
          fail(body, "touches",
               fmt::format("touches \"{}\": no body is in this group{}", name, suggest(name, groups)));
  }

  /// Refuses `continuous` if the body has no collision shape.
  void check_fidelity(Fidelity collision, bool continuous, const Entry& body) const {
    if (collision == Fidelity::none && continuous)
      fail(body, "continuous", "continuous needs a collision shape: collision is \"none\"");
  }

  void check_label(int label, const std::string& volume, const Entry& body) const {
    if (label == 0)
      fail(body, "label", "label = 0 is the background; allowed: 1 to 65535, or -1: voxels above threshold");
    if (label > 0 && volume.empty()) fail(body, "label", "label needs a volume");
  }

  void check_rigid(const RigidDesc& rigid, const Entry& body) const {
    const bool swept = !rigid.geometry.curves.empty() || !rigid.geometry.patches.empty();
    const int sources =
        !rigid.geometry.mesh.empty() + !rigid.geometry.volume.empty() + !rigid.geometry.parts.empty() + swept;
    if (sources != 1)
      fail(body, rigid.geometry.volume.empty() ? "mesh" : "volume",
           sources == 0 ? "no geometry: give one of mesh, volume, [[rigid.part]]s, and curves or patches"
                        : "has several of mesh, volume, [[rigid.part]]s, and curves or patches: give one");
    if (!rigid.geometry.fallback.empty() && (!rigid.geometry.parts.empty() || swept))
      fail(body, "fallback",
           "fallback replaces a missing mesh or volume file, but the body names no such file");
    check_curves(rigid.geometry.curves, rigid.geometry.patches, body);
    check_label(rigid.geometry.label, rigid.geometry.volume, body);
    if (rigid.break_force > 0 && rigid.fractures.empty())
      fail(body, "break_force", "break_force needs a [[rigid.fracture]] to break along");
    if (rigid.fixed && (rigid.part || rigid.break_force > 0))
      fail(body, "fixed", "a fixed body cannot be anatomy, which can be detached, and cannot break");
    for (std::size_t i = 0; i < rigid.fractures.size(); ++i)
      if (rigid.fractures[i].normal.isZero(1e-9))
        fail(fmt::format("{}.fracture[{}]", body.table, i), "normal",
             fmt::format("{}: [[rigid.fracture]] {}", body.where, i + 1), "normal is zero");
    for (std::size_t i = 0; i < rigid.edges.size(); ++i) {
      const auto refuse = [&](const char* key, const char* why) {
        fail(fmt::format("{}.edge[{}]", body.table, i), key,
             fmt::format("{}: [[rigid.edge]] {}", body.where, i + 1), why);
      };
      if (rigid.fixed)
        refuse("from",
               "an edge cuts only while a hand holds the body, but the body is fixed; remove the edge or "
               "fixed = true");
      if ((rigid.edges[i].to - rigid.edges[i].from).norm() < least_edge)
        refuse("to", "is shorter than 0.1 mm");
    }
    check_fidelity(rigid.contact.collision, rigid.contact.continuous, body);
  }

  void check_soft(const SoftDesc& soft, const Entry& body) const {
    const int sources =
        !soft.geometry.volume.empty() + !soft.geometry.mesh.empty() + !soft.geometry.shape.empty();
    if (sources != 1)
      fail(body, soft.geometry.shape.empty() ? "mesh" : "shape",
           fmt::format("has {} of volume, mesh and shape: give exactly one", sources));
    if (!soft.geometry.fallback.empty() && !soft.geometry.shape.empty())
      fail(body, "fallback", "fallback replaces a missing volume or mesh file, but only a shape is given");
    check_label(soft.geometry.label, soft.geometry.volume, body);
    if (soft.material.fiber_direction.isZero(1e-9)) fail(body, "fiber_direction", "fiber_direction is zero");
    check_fidelity(soft.contact.collision, soft.contact.continuous, body);
    if (soft.contact.self_contact && soft.contact.collision != Fidelity::mesh)
      fail(body, "self_contact",
           fmt::format("self_contact needs collision = \"mesh\": collision is \"{}\"",
                       fidelity_name(soft.contact.collision)));
    check_grading(soft, body);
    check_refinement(soft, body);
    if (soft.geometry.is_rope() && soft.contact.collision == Fidelity::hull)
      fail(body, "collision", "a rope has no hull: must be one of none, sphere, aabb, obb, mesh");
    if (soft.material.tension && soft.geometry.is_rope())
      fail(body, "tension",
           "tension is the pre-strain of an outermost layer, which a rope does not have; allowed for solid "
           "bodies and sheets");
    check_regions(soft, body);
    check_curves(soft.geometry.curves, soft.geometry.patches, body);
    if (!soft.geometry.curves.empty() && !soft.geometry.is_rope())
      fail(body, "curve[0]", "[[soft.curve]] needs a rope: shape = \"rope\"");
    if (!soft.geometry.patches.empty() && !soft.geometry.is_sheet())
      fail(body, "patch[0]", "[[soft.patch]] needs a sheet: shape = \"sheet\"");
    double shares = 0;
    for (const RelaxationDesc& term : soft.material.relaxation) shares += term.share;
    if (shares >= 1)
      fail(body, "relaxation[0]",
           fmt::format("the shares of [[soft.relaxation]] add up to {}: must be below 1", shares));
    check_need(soft, body);
  }

  /// Checks that each curve and patch description can be built.
  void check_curves(const std::vector<CurveDesc>& curves, const std::vector<PatchDesc>& patches,
                    const Entry& body) const {
    const auto check = [&](const char* key, std::size_t i, const auto& make) {
      try {
        make();
      } catch (const InputError& error) {
        fail(fmt::format("{}.{}[{}]", body.table, key, i), "",
             fmt::format("{}: {} {}", body.where, key, i + 1), error.what());
      }
    };
    for (std::size_t i = 0; i < curves.size(); ++i) check("curve", i, [&] { make_curve(curves[i]); });
    for (std::size_t i = 0; i < patches.size(); ++i) check("patch", i, [&] { make_patch(patches[i]); });
  }

  void check_regions(const SoftDesc& soft, const Entry& body) const {
    for (std::size_t i = 0; i < soft.material.regions.size(); ++i) {
      const RegionDesc& region = soft.material.regions[i];
      const auto refuse = [&](const char* key, const std::string& what) {
        fail(fmt::format("{}.region[{}]", body.table, i), key,
             fmt::format("{}: [[soft.region]] {}", body.where, i + 1), what);
      };
      if (!region.size.isZero(0) && !(region.size.array() > 0).all())
        refuse("size", "size of a region must be three positive numbers for a box, or all 0 for a sphere");
    }
  }

  void check_grading(const SoftDesc& soft, const Entry& body) const {
    if (soft.geometry.grade != Grading::none && !soft.geometry.is_solid())
      fail(body, "grade",
           fmt::format("grade is for solid bodies: a {} has no tetrahedra", soft.geometry.shape));
  }

  void check_refinement(const SoftDesc& soft, const Entry& body) const {
    if (soft.refinement.at == Refining::none) return;
    if (!soft.geometry.is_solid())
      fail(body, "refine",
           fmt::format("refine is for solid bodies: a {} has no tetrahedra", soft.geometry.shape));
    if (soft.configuration.is_quadratic())
      fail(body, "refine",
           fmt::format("refine = \"touch\" needs linear elements: element is \"{}\"; allowed: tet4",
                       soft.configuration.element));
    if (soft.refinement.cell >= soft.geometry.cell)
      fail(body, "refine_cell",
           fmt::format("refine_cell is {} m; it must be smaller than cell, which is {} m",
                       soft.refinement.cell, soft.geometry.cell));
  }

  /// Checks the keys that may be given together with `accuracy` or `budget`.
  void check_need(const SoftDesc& soft, const Entry& body) const {
    if (!soft.choice.accuracy && !soft.choice.budget) return;
    const char* need = soft.choice.accuracy ? "accuracy" : "budget";
    if (soft.choice.accuracy && soft.choice.budget)
      fail(body, "budget", "accuracy and budget are both given: give only one of them");
    const auto& judged = soft.choice.accuracy_of;
    if (judged.empty() || std::any_of(judged.begin(), judged.end(), [](const std::string& act) {
          return act != "shape" && act != "touch";
        }))
      fail(body, "accuracy_of", "accuracy_of: allowed: \"shape\", \"touch\", or both");
    if (!soft.geometry.is_solid())
      fail(body, need,
           fmt::format("{} is for solid bodies, since a {} has no continuum reference solution; allowed "
                       "instead: model = \"mass_spring\" or \"xpbd\", an integrator, and a cell",
                       need, soft.geometry.shape));
    for (const char* key : {"newton_iterations", "solver_iterations", "solver_tolerance", "substeps"})
      if (lines_.has(body.table, key))
        fail(body, key, fmt::format("the server chooses {} if {} is given: omit one of them", key, need));
    if (soft.choice.fixed.integrator && soft.configuration.integrator != SoftDesc{}.configuration.integrator)
      fail(body, "integrator",
           fmt::format("integrator = \"{}\": allowed with {}: {}", soft.configuration.integrator, need,
                       SoftDesc{}.configuration.integrator));
  }

  void check_lights() const {
    std::map<std::string_view, std::size_t> seen;
    for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
      const LightDesc& light = scene_.lights[i];
      const std::string table = fmt::format("light[{}]", i);
      const std::string where = light.name.empty() ? fmt::format("[[light]] {}", i + 1)
                                                   : fmt::format("[[light]] \"{}\"", light.name);
      if (light.direction.isZero(1e-9)) fail(table, "direction", where, "direction is zero");
      const auto is_it = [&](const RigidDesc& rigid) { return rigid.name == light.carrier; };
      if (!light.carrier.empty() && std::none_of(scene_.rigid.begin(), scene_.rigid.end(), is_it))
        fail(table, "body", where, fmt::format("body = \"{}\": no [[rigid]] has this name", light.carrier));
      if (!light.name.empty() && !seen.emplace(light.name, i).second)
        fail(table, "name", where, "this name is already used by another light; names must differ");
    }
  }

  const SceneDesc& scene_;
  const SourceLines& lines_;
  std::vector<Entry> bodies_;
};

}  // namespace

int SourceLines::of(const std::string& table, const std::string& key) const {
  if (const auto line = lines_.find(table.empty() ? key : table + "." + key); line != lines_.end())
    return line->second;
  const auto line = lines_.find(table);
  return line == lines_.end() ? 1 : line->second;
}

bool SourceLines::has(const std::string& table, const std::string& key) const {
  return lines_.contains(table + "." + key);
}

void set_fixed_choices(SceneDesc& scene, const SourceLines& lines) {
  for (std::size_t i = 0; i < scene.soft.size(); ++i) {
    SoftDesc& soft = scene.soft[i];
    const std::string table = fmt::format("soft[{}]", i);
    soft.choice.fixed = {
        lines.has(table, "model"), lines.has(table, "element"), lines.has(table, "integrator"),
        lines.has(table, "solver"),
        // A tetrahedral mesh file has a fixed cell size.
        lines.has(table, "cell") || (!soft.geometry.mesh.empty() && !is_surface_file(soft.geometry.mesh)),
        lines.has(table, "grade")};
  }
}

void check_scene(const SceneDesc& scene, const SourceLines& lines) {
  Checker(scene, lines).run();
}

}  // namespace prosector
