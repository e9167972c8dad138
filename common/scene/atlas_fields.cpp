#include "common/scene/body_fields.h"
#include "common/scene/material.h"

namespace prosector {
namespace {

/// Returns the names of all materials, preceded by material_by_name.
std::vector<std::string_view> material_words() {
  std::vector<std::string_view> out = material_names();
  out.insert(out.begin(), material_by_name);
  return out;
}

}  // namespace

const Table& atlas_table() {
  using A = AtlasDesc;
  static const Table table = [] {
    Table t{
        "[[atlas]]",
        "An `[[atlas]]` creates one body per label of a label map, named after the label: rigid for bone, "
        "soft otherwise, all held in place. An atlas's label table is CSV with a header row: `name`, and any "
        "of `id` (in the label map), `name.LANGUAGE` (`name.de`), `ta` (Terminologia Anatomica 1998) and "
        "`color` (#rrggbb). Alternatively, each line of a label table is a number, a name, and a code or a "
        "colour, as published atlases provide. An `[[atlas]]` omits labels that are not in its label table, "
        "and labels of fewer than 64 voxels that are not listed in `only`.",
        {text<A, &A::volume>("volume", compiled, "file of the label map: .inr .inr.gz .nii .nii.gz", true),
         text<A, &A::labels>("labels", compiled,
                             "file of the label table; default: all labels, named \"region 1\" ..."),
         names<A, &A::only>("only", compiled, "names of labels to include; default: all"),
         names<A, &A::leave_out>("leave_out", compiled, "names of labels to omit"),
         words<A, &A::material>("material", compiled, material_words(),
                                "material of the bodies; `by name`: chosen by a word in each label's name, "
                                "such as kidney, else tissue"),
         number<A, &A::cell>(
             "cell", compiled, "m", {0, 1},
             "soft bodies: edge length of elements; 0: from each body's volume and thickness"),
         number<A, &A::surface_cell>("surface_cell", compiled, "m", {5e-4, 1}, "as in [[soft]]"),
         number<A, &A::smoothing>("smoothing", compiled, "voxels", {0, 10}, "as in [[soft]]"),
         quantity<A, &A::max_volume_error>("max_volume_error", not_hashed, "%", {0, 1000, true},
                                           "allowed volume error of each body, as in [[soft]]"),
         identifier<A, &A::model>("model", compiled, "soft bodies: constitutive law, as in [[soft]]"),
         words<A, &A::element>("element", compiled, {"tet4", "tet10"},
                               "soft bodies: element type, as in [[soft]]"),
         identifier<A, &A::integrator>("integrator", compiled,
                                       "soft bodies: time integrator, as in [[soft]]"),
         identifier<A, &A::solver>("solver", compiled, "soft bodies: linear solver, as in [[soft]]"),
         number<A, &A::hold>("hold", compiled, "N/m per m³", {0, 1e12},
                             "soft bodies: stiffness of ties that hold the whole body in place; 0: none"),
         number<A, &A::damping_mass>("damping_mass", compiled, "1/s", {0, 1000},
                                     "soft bodies: Rayleigh damping, as in [[soft]]"),
         plain<A, &A::gravity>("gravity", compiled, "as in [[soft]]"),
         name<A, &A::group>("group", compiled, false, "their collision group"),
         names<A, &A::touches>("touches", compiled,
                               "collision groups that the bodies touch; omit their own group so that "
                               "adjacent bodies need no contacts")},
        {},
        fresh<A>};
    add_pose<A>(t.fields, "the volume's centre in the room");
    return t;
  }();
  return table;
}

}  // namespace prosector
