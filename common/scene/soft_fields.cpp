#include "common/scene/body_fields.h"
#include "common/scene/curve_fields.h"

namespace prosector {
namespace {

/// Returns the shapes of soft bodies, also those that aren't solid.
std::vector<std::string_view> soft_shapes() {
  auto out = implicit_shape_words();
  out.insert(out.end(), {"sheet", "rope"});
  return out;
}

const Table& attach_table() {
  using A = AttachDesc;
  static const Table table{
      "[[soft.attach]]",
      "Tissue that holds an organ to its place: what lies inside the sphere is tied elastically to where it "
      "rests.",
      {number<A, &A::center>("center", compiled, "m", coordinate, "of the sphere, in the room"),
       number<A, &A::radius>("radius", compiled, "m", {0, 10, true}, "of the sphere"),
       number<A, &A::stiffness>("stiffness", compiled, "N/m per m³", {0, 1e12},
                                "of the ties, for each cubic metre of tissue that they hold")},
      {},
      fresh<A>};
  return table;
}

const Table& region_table() {
  using R = RegionDesc;
  static const Table table{
      "[[soft.region]]",
      "Part of a body on tetrahedra that is made of something else: the elements whose middle, at rest, lies "
      "inside a sphere, or a box where `size` is given. Where regions overlap, the last one holds.",
      {number<R, &R::center>("center", by_value, "m", coordinate, "of the sphere or box, in the room"),
       number<R, &R::radius>("radius", by_value, "m", {0, 10, true}, "of the sphere"),
       number<R, &R::size>("size", by_value, "m", {0, 10},
                           "full extents of the box along the room's axes; zero: it is a sphere"),
       number<R, &R::youngs_modulus>("youngs_modulus", by_value, "Pa", {0, 1e12}, "0: the body's"),
       number<R, &R::poisson_ratio>("poisson_ratio", by_value, "", {-1, 0.5, false, true},
                                    "below 0: the body's"),
       number<R, &R::fiber_stiffness>("fiber_stiffness", by_value, "Pa", {-1, 1e12}, "below 0: the body's"),
       number<R, &R::fiber_direction>("fiber_direction", by_value, "", {-1000, 1000}, "zero: the body's")},
      {},
      fresh<R>};
  return table;
}

const Table& relaxation_table() {
  using R = RelaxationDesc;
  static const Table table{
      "[[soft.relaxation]]",
      "A term of a Prony series: of the stress that a sudden strain raises, `share` dies out as "
      "exp(-t / `time`). `youngs_modulus` is the stiffness at once; what the shares leave of it, together "
      "below 1, stays. For models whose name starts with fem_, with an implicit integrator.",
      {number<R, &R::share>("share", by_value, "", {0, 1, true, true}, "of the stress"),
       number<R, &R::time>("time", by_value, "s", {1e-6, 1e6}, "in which it falls to 1/e")},
      {},
      fresh<R>};
  return table;
}

}  // namespace

const Table& soft_table() {
  using S = SoftDesc;
  static const Table table = [] {
    Table t{
        "[[soft]]",
        "A body that deforms. Its geometry is exactly one of `volume`, `mesh` and `shape`.",
        {name<S, &S::name>("name", by_value, true, "unique among all bodies"),
         text<S, &S::description>("description", not_hashed, "for people"),
         name<S, &S::parent>("parent", not_hashed, false,
                             "body that it belongs to in the scene graph; not given: the room"),
         text<S, &S::volume>("volume", compiled,
                             "labelled or grey medical volume: .inr .inr.gz .nii .nii.gz"),
         number<S, &S::label>("label", compiled, "", {-1, 65535},
                              "volumes: label to take, not 0; -1: what is above threshold"),
         number<S, &S::threshold>("threshold", compiled, "", {-1e6, 1e6}, "grey volumes: inside is above it"),
         text<S, &S::mesh>("mesh", compiled,
                           "tetrahedra: .msh .vtk; or a closed surface, which is filled with them: .obj .stl "
                           ".ply .off .gltf .glb"),
         words<S, &S::shape>(
             "shape", compiled, soft_shapes(),
             "implicit shape, `size` large; or a sheet in the x-z plane or over a patch, or a rope along "
             "x or a curve, for mass_spring and xpbd"),
         words<S, &S::fallback>(
             "fallback", compiled, implicit_shape_words(),
             "implicit shape used, with a clear line, when the volume or mesh file is missing"),
         number<S, &S::size>(
             "size", compiled, "m", {0, 10, true},
             "bounding box of the implicit shape or fallback; sheet: thickness in y; rope: length "
             "in x, diameter in y"),
         number<S, &S::scale>("scale", compiled, "", scale,
                              "mesh files: file units to metres (volumes know theirs)"),
         number<S, &S::cell>("cell", by_value, "m", {5e-4, 1},
                             "edge length of the tetrahedra, a sheet's cells or a rope's pieces, about"),
         number<S, &S::surface_cell>("surface_cell", compiled, "m", {5e-4, 1},
                                     "edge length of the surface that is touched and drawn, about"),
         number<S, &S::smoothing>("smoothing", compiled, "voxels", {0, 10},
                                  "volumes: Gaussian σ on the label's mask"),
         identifier<S, &S::model>("model", by_value, "constitutive law, mass_spring or xpbd"),
         words<S, &S::element>(
             "element", by_value, {"tet4", "tet10"},
             "tetrahedra: linear, or quadratic (ten nodes: a tenth of the elements for the same error)"),
         identifier<S, &S::integrator>("integrator", by_value,
                                       "time integrator, for instance implicit_euler; xpbd has its own"),
         identifier<S, &S::solver>("solver", by_value, "linear solver, for instance cg"),
         number<S, &S::youngs_modulus>("youngs_modulus", by_value, "Pa", {0, 1e12, true},
                                       "stiffness in tension"),
         number<S, &S::poisson_ratio>("poisson_ratio", by_value, "", {0, 0.5, false, true},
                                      "sideways over lengthways strain; towards 0.5 the volume is kept"),
         number<S, &S::fiber_stiffness>("fiber_stiffness", by_value, "Pa", {0, 1e12},
                                        "model fem_fibers: what its fibres add along themselves in tension"),
         number<S, &S::fiber_direction>("fiber_direction", by_value, "", {-1000, 1000},
                                        "of the fibres at rest, in the room; any length but zero"),
         number<S, &S::density>("density", by_value, "kg/m³", density, ""),
         number<S, &S::damping_mass>("damping_mass", by_value, "1/s", {0, 1000},
                                     "Rayleigh damping: share of the mass"),
         number<S, &S::damping_stiffness>("damping_stiffness", by_value, "s", {0, 10},
                                          "Rayleigh damping: share of the stiffness"),
         number<S, &S::friction>("friction", by_value, "", friction, "Coulomb coefficient"),
         number<S, &S::rolling_resistance>(
             "rolling_resistance", by_value, "", unit_interval,
             "force that resists free rolling, over the load, of what collides as a sphere or a hull"),
         number<S, &S::toughness>("toughness", by_value, "J/m²", {0, 1e6},
                                  "work that a cut takes, for its area; 0: blades meet no resistance"),
         quantity<S, &S::tension>("tension", by_value, "%", {0, 30, true},
                                  "by how much less a body's outermost layer would be along its surface if "
                                  "nothing held it: it is stretched, what is below holds it, and a cut "
                                  "through it gapes (docs/understand/soft-tissue.md). Of a sheet, all of it: "
                                  "[[soft.attach]] holds it"),
         number<S, &S::tension_depth>("tension_depth", by_value, "m", {0, 1, true},
                                      "how thick the layer under tension is, in solid bodies"),
         plain<S, &S::gravity>("gravity", by_value, "false: the imaged shape already carries its weight"),
         number<S, &S::newton_iterations>("newton_iterations", by_value, "", {1, 100}, "at most, per tick"),
         number<S, &S::solver_iterations>("solver_iterations", by_value, "", {1, 100000},
                                          "of the linear solver, at most, per Newton iteration"),
         number<S, &S::solver_tolerance>("solver_tolerance", by_value, "", {0, 0.5, true},
                                         "relative residual at which the linear solver stops; its root where "
                                         "several Newton iterations follow"),
         number<S, &S::substeps>("substeps", by_value, "", {1, 1000}, "xpbd: per tick"),
         number<S, &S::max_substeps>(
             "max_substeps", by_value, "", {1, 100000},
             "explicit integrators: at most, per tick; a body that needs more is stepped by implicit_euler"),
         number<S, &S::spring_stiffness>(
             "spring_stiffness", by_value, "N/m", {0, 1e12},
             "mass_spring, xpbd: of each structural spring; 0: from youngs_modulus"),
         number<S, &S::shear_stiffness>("shear_stiffness", by_value, "N/m", {0, 1e12},
                                        "sheets: of each diagonal spring; 0: from youngs_modulus"),
         number<S, &S::bending_stiffness>(
             "bending_stiffness", by_value, "N·m", {0, 1e9},
             "sheets: Et³/12(1-ν²); ropes: EI, in N·m²; 0: from youngs_modulus and thickness"),
         plain<S, &S::hold_volume>(
             "hold_volume", by_value,
             "mass_spring on tetrahedra: volume springs that meet poisson_ratio; false: springs "
             "alone, whose ratio is about 1/4"),
         quantity<S, &S::accuracy>(
             "accuracy", not_hashed, "%", {0, 100, true},
             "instead of a rung, for solid bodies: how far the body may rest from where "
             "tissue would, in each of what accuracy_of names; the server chooses the "
             "cheapest rung that it found good enough on this very body "
             "(docs/understand/soft-tissue.md). What of "
             "model, element, integrator, solver and cell is given beside it is kept"),
         names<S, &S::accuracy_of>(
             "accuracy_of", not_hashed,
             "what accuracy and budget are judged by: \"shape\", under its weight, hung "
             "and on its side; \"touch\", dented by a fingertip"),
         quantity<S, &S::budget>("budget", not_hashed, "ms", {0, 1000, true},
                                 "instead of a rung, for solid bodies: CPU time that the body may take in a "
                                 "frame of 1/60 s; the server chooses "
                                 "the most accurate rung within it, as for accuracy"),
         plain<S, &S::step_down>(
             "step_down", not_hashed,
             "true: while the server is overloaded, this body may be solved with fewer iterations or "
             "substeps; clients are told"),
         plain<S, &S::show_figures>("show_figures", not_hashed,
                                    "true: clients show how it is stepped, live, above it"),
         plain<S, &S::part>(
             "anatomy", by_value,
             "true: part of the anatomy: `attach` holds it to its place until somebody detaches "
             "it; a touch brings up its panel"),
         number<S, &S::snap>("snap", by_value, "m", {0, 1},
                             "how near to its place a detached part must be to be attached again")},
        {{"curve", soft_curve_table, true, 1, items<S, &S::curves>},
         {"patch", soft_patch_table, true, 1, items<S, &S::patches>},
         {"attach", attach_table, true, 64, items<S, &S::attach>},
         {"region", region_table, true, 64, items<S, &S::regions>},
         {"relaxation", relaxation_table, true, 8, items<S, &S::relaxation>}},
        fresh<S>};
    add_collision<S>(
        t.fields, {"none", "sphere", "aabb", "obb", "hull", "mesh"},
        "what it collides as: its triangles (mesh); the ball, box (aabb: along the room's axes; obb: "
        "along its own) or hull around them, fitted anew in each tick, that makes no dents; or nothing");
    t.fields.push_back(plain<S, &S::self_contact>(
        "self_contact", by_value,
        "true: it doesn't pass through itself where it folds; collision must be mesh"));
    t.fields.push_back(words<S, &S::contact>(
        "contact", by_value, {"vertices", "surface"},
        "where rigid things press it: at its vertices, or over the area that touches; the latter is for "
        "solids that collide as mesh and have no substeps"));
    t.fields.push_back(words<S, &S::grade>(
        "grade", compiled, {"none", "rims"},
        "rims: a solid has smaller elements where the surface that is attached meets the free one, since "
        "stress is largest there (docs/decisions/0026-graded-at-the-rims.md)"));
    t.fields.push_back(words<S, &S::refine>(
        "refine", by_value, {"none", "touch"},
        "touch: a solid of linear tetrahedra has smaller ones where hands, and what they hold or push, touch "
        "it, until a second after they left (docs/understand/contact.md); not once it was cut"));
    t.fields.push_back(number<S, &S::refine_cell>("refine_cell", by_value, "m", {0, 1},
                                                  "as cell, of these smaller ones; 0: half of cell"));
    t.fields.push_back(
        number<S, &S::refine_reach>("refine_reach", by_value, "m", {0, 1},
                                    "how far from what touches it they are smaller; 0: as far as cell"));
    t.fields.push_back(number<S, &S::refine_most>("refine_most", by_value, "", {1, 1000000},
                                                  "elements, at most, that it has more for that"));
    add_file_reading<S>(t.fields);
    add_pose<S>(t.fields, "the mesh's origin, or the volume's or shape's centre, in the room");
    add_fallback_pose<S>(t.fields);
    add_appearance<S>(t.fields);
    return t;
  }();
  return table;
}

}  // namespace prosector
