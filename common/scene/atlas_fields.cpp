#include "common/scene/body_fields.h"
#include "common/scene/material.h"

namespace prosector {
namespace {

/// Returns the materials, and the word for one by each name.
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
        "The structures of a label map as bodies, each by the name of its label: of bone rigid ones, of "
        "anything else soft ones, all held to their places. A table of labels is CSV whose first row names "
        "its columns: `name`, and any of `id` (in the label map), `name.LANGUAGE` (`name.de`), `ta` "
        "(Terminologia Anatomica 1998) and `color` (#rrggbb). Or its lines are a number, a name, and a code "
        "or a colour, as atlases come with. Labels of the map that the table doesn't name are left out, "
        "and so are those of fewer than 64 voxels that `only` doesn't name.",
        {text<A, &A::volume>("volume", compiled, "label map: .inr .inr.gz .nii .nii.gz", true),
         text<A, &A::labels>("labels", compiled,
                             "table of labels; not given: all labels, as \"region 1\" ..."),
         names<A, &A::only>("only", compiled, "names of labels to take; none given: all"),
         names<A, &A::leave_out>("leave_out", compiled, "names of labels to leave out"),
         words<A, &A::material>(
             "material", compiled, material_words(),
             "what they are made of; by name: by a word of each one's name, such as kidney, "
             "else tissue"),
         number<A, &A::cell>("cell", compiled, "m", {0, 1},
                             "of soft ones, as of [[soft]]; 0: by each one's volume and thickness"),
         number<A, &A::surface_cell>("surface_cell", compiled, "m", {5e-4, 1}, "as of [[soft]]"),
         number<A, &A::smoothing>("smoothing", compiled, "voxels", {0, 10}, "as of [[soft]]"),
         quantity<A, &A::max_volume_error>("max_volume_error", not_hashed, "%", {0, 1000, true},
                                           "of each, as of [[soft]]"),
         identifier<A, &A::model>("model", compiled, "of soft ones, as of [[soft]]"),
         words<A, &A::element>("element", compiled, {"tet4", "tet10"}, "of soft ones, as of [[soft]]"),
         identifier<A, &A::integrator>("integrator", compiled, "of soft ones, as of [[soft]]"),
         identifier<A, &A::solver>("solver", compiled, "of soft ones, as of [[soft]]"),
         number<A, &A::hold>("hold", compiled, "N/m per m³", {0, 1e12},
                             "soft ones: what ties all of each to its place; 0: nothing does"),
         number<A, &A::damping_mass>("damping_mass", compiled, "1/s", {0, 1000},
                                     "of soft ones, as of [[soft]]"),
         plain<A, &A::gravity>("gravity", compiled, "as of [[soft]]"),
         name<A, &A::group>("group", compiled, false, "collision group that they belong to"),
         names<A, &A::touches>("touches", compiled,
                               "groups that they touch; without their own, what lies against each other "
                               "needs no contacts")},
        {},
        fresh<A>};
    add_pose<A>(t.fields, "the volume's centre in the room");
    return t;
  }();
  return table;
}

}  // namespace prosector
