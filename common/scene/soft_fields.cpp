#include "common/scene/body_fields.h"
#include "common/scene/curve_fields.h"

namespace prosector {
namespace {

/// Returns the shapes of soft bodies: the implicit shapes, sheet and rope.
std::vector<std::string_view> soft_shapes() {
  auto out = implicit_shape_words();
  out.insert(out.end(), {"sheet", "rope"});
  return out;
}

const Table& attach_table() {
  using A = AttachDesc;
  static const Table table{
      "[[soft.attach]]",
      "An `attach` table models tissue that holds a soft body in place: the part of the body inside a sphere "
      "is tied elastically to its rest position.",
      {number<A, &A::center>("center", compiled, "m", coordinate, "centre of the sphere, in the room"),
       number<A, &A::radius>("radius", compiled, "m", {0, 10, true}, "radius of the sphere"),
       number<A, &A::stiffness>("stiffness", compiled, "N/m per m³", {0, 1e12},
                                "stiffness of the ties per cubic metre of held tissue")},
      {},
      fresh<A>};
  return table;
}

const Table& region_table() {
  using R = RegionDesc;
  static const Table table{
      "[[soft.region]]",
      "A `region` table gives part of a tetrahedral body another material: the elements whose centre at rest "
      "is inside a sphere, or a box if `size` is given. Where `region` tables overlap, the last one applies.",
      {number<R, &R::center>("center", by_value, "m", coordinate, "centre of the sphere or box, in the room"),
       number<R, &R::radius>("radius", by_value, "m", {0, 10, true}, "radius of the sphere"),
       number<R, &R::size>("size", by_value, "m", {0, 10},
                           "full extents of the box along the room's axes; zero: a sphere"),
       number<R, &R::youngs_modulus>("youngs_modulus", by_value, "Pa", {0, 1e12}, "0: as the body"),
       number<R, &R::poisson_ratio>("poisson_ratio", by_value, "", {-1, 0.5, false, true},
                                    "below 0: as the body"),
       number<R, &R::fiber_stiffness>("fiber_stiffness", by_value, "Pa", {-1, 1e12}, "below 0: as the body"),
       number<R, &R::fiber_direction>("fiber_direction", by_value, "", {-1000, 1000}, "zero: as the body")},
      {},
      fresh<R>};
  return table;
}

const Table& relaxation_table() {
  using R = RelaxationDesc;
  static const Table table{
      "[[soft.relaxation]]",
      "A `relaxation` table is a term of a Prony series: after a sudden strain, the fraction `share` of the "
      "stress decays as exp(-t / `time`). In a body with `relaxation`, `youngs_modulus` is the instantaneous "
      "stiffness; the sum of all `share` values must be below 1. The keys of `relaxation` require a `model` "
      "whose name starts with fem_, and an implicit integrator.",
      {number<R, &R::share>("share", by_value, "", {0, 1, true, true}, "fraction of the stress"),
       number<R, &R::time>("time", by_value, "s", {1e-6, 1e6}, "relaxation time: decay to 1/e")},
      {},
      fresh<R>};
  return table;
}

using S = SoftDesc;

/// Returns the keys of [[soft]] for the body's name and place in the scene graph.
std::vector<Field> identity_fields() {
  return {
      name<S, &S::name>("name", by_value, true, "unique among all bodies"),
      text<S, &S::description>("description", not_hashed, "description for users"),
      name<S, &S::parent>("parent", not_hashed, false, "parent body in the scene graph; default: the room")};
}

/// Returns the keys of [[soft]] for the body's shape and the sizes of its elements.
std::vector<Field> geometry_fields() {
  return {text<S, &S::geometry, &SoftGeometry::volume>(
              "volume", compiled, "file of a labelled or grey medical volume: .inr .inr.gz .nii .nii.gz"),
          number<S, &S::geometry, &SoftGeometry::label>(
              "label", compiled, "", {-1, 65535},
              "volumes: label of the body's voxels, not 0; -1: voxels above threshold"),
          number<S, &S::geometry, &SoftGeometry::threshold>(
              "threshold", compiled, "", {-1e6, 1e6},
              "grey volumes: voxels with larger values are inside the body"),
          text<S, &S::geometry, &SoftGeometry::mesh>(
              "mesh", compiled,
              "tetrahedra: .msh .vtk; or a closed surface to fill with tetrahedra: .obj .stl "
              ".ply .off .gltf .glb"),
          words<S, &S::geometry, &SoftGeometry::shape>(
              "shape", compiled, soft_shapes(),
              "implicit shape of the given `size`; or, for mass_spring and xpbd, a sheet in "
              "the x-z plane or over a patch, or a rope along x or a curve"),
          words<S, &S::geometry, &SoftGeometry::fallback>(
              "fallback", compiled, implicit_shape_words(),
              "implicit shape used if the volume or mesh file is missing; this is reported"),
          number<S, &S::geometry, &SoftGeometry::size>(
              "size", compiled, "m", {0, 10, true},
              "bounding box of the implicit shape or fallback; sheet: thickness in y; rope: length "
              "in x, diameter in y"),
          number<S, &S::geometry, &SoftGeometry::scale>(
              "scale", compiled, "", scale,
              "mesh files: factor from file units to metres (volumes contain theirs)"),
          number<S, &S::geometry, &SoftGeometry::cell>(
              "cell", by_value, "m", {5e-4, 1},
              "approximate edge length of the tetrahedra, sheet cells or rope segments"),
          number<S, &S::geometry, &SoftGeometry::surface_cell>(
              "surface_cell", compiled, "m", {5e-4, 1},
              "approximate edge length of the collision and rendering surface"),
          number<S, &S::geometry, &SoftGeometry::smoothing>(
              "smoothing", compiled, "voxels", {0, 10}, "volumes: σ of the Gaussian that smooths the mask")};
}

/// Returns the keys of [[soft]] for the body's model, element type, integrator and linear solver.
std::vector<Field> model_fields() {
  return {identifier<S, &S::configuration, &SoftConfiguration::model>(
              "model", by_value, "constitutive law (fem_...), mass_spring or xpbd"),
          words<S, &S::configuration, &SoftConfiguration::element>(
              "element", by_value, {"tet4", "tet10"},
              "tetrahedra: linear (tet4), or quadratic (tet10: ten nodes, the same error "
              "with a tenth of the elements)"),
          identifier<S, &S::configuration, &SoftConfiguration::integrator>(
              "integrator", by_value, "time integrator, e.g. implicit_euler; xpbd has its own"),
          identifier<S, &S::configuration, &SoftConfiguration::solver>("solver", by_value,
                                                                       "linear solver, e.g. cg")};
}

/// Returns the keys of [[soft]] for elastic constants, density and damping.
std::vector<Field> elasticity_fields() {
  return {
      number<S, &S::material, &SoftMaterial::youngs_modulus>("youngs_modulus", by_value, "Pa",
                                                             {0, 1e12, true}, "Young's modulus"),
      number<S, &S::material, &SoftMaterial::poisson_ratio>("poisson_ratio", by_value, "",
                                                            {0, 0.5, false, true},
                                                            "Poisson's ratio; towards 0.5 incompressible"),
      number<S, &S::material, &SoftMaterial::fiber_stiffness>(
          "fiber_stiffness", by_value, "Pa", {0, 1e12},
          "model fem_fibers: additional stiffness of the fibres in tension, along their direction"),
      number<S, &S::material, &SoftMaterial::fiber_direction>(
          "fiber_direction", by_value, "", {-1000, 1000},
          "direction of the fibres at rest, in the room; any non-zero length"),
      number<S, &S::material, &SoftMaterial::density>("density", by_value, "kg/m³", density,
                                                      "density of the tissue"),
      number<S, &S::material, &SoftMaterial::damping_mass>("damping_mass", by_value, "1/s", {0, 1000},
                                                           "Rayleigh damping: factor of the mass matrix"),
      number<S, &S::material, &SoftMaterial::damping_stiffness>(
          "damping_stiffness", by_value, "s", {0, 10}, "Rayleigh damping: factor of the stiffness matrix")};
}

/// Returns the keys of [[soft]] for friction and rolling resistance.
std::vector<Field> friction_fields() {
  return {number<S, &S::contact, &SoftContact::friction>("friction", by_value, "", friction,
                                                         "Coulomb coefficient"),
          number<S, &S::contact, &SoftContact::rolling_resistance>(
              "rolling_resistance", by_value, "", unit_interval,
              "rolling resistance force divided by load, for collision shapes sphere and hull")};
}

/// Returns the keys of [[soft]] for toughness and pre-strain, and whether the body has weight.
std::vector<Field> cutting_fields() {
  return {
      number<S, &S::material, &SoftMaterial::toughness>("toughness", by_value, "J/m²", {0, 1e6},
                                                        "work of cutting per cut area; 0: no resistance"),
      quantity<S, &S::material, &SoftMaterial::tension>(
          "tension", by_value, "%", {0, 30, true},
          "pre-strain of a body's outermost layer: fraction by which it would shrink along the surface if "
          "released, so that cuts gape (docs/understand/soft-tissue.md). In a sheet: pre-strain of the "
          "whole sheet, held by [[soft.attach]]"),
      number<S, &S::material, &SoftMaterial::tension_depth>(
          "tension_depth", by_value, "m", {0, 1, true},
          "thickness of the pre-strained layer, in solid bodies"),
      plain<S, &S::gravity>("gravity", by_value, "false: no weight, since the imaged shape carries it")};
}

/// Returns the keys of [[soft]] for limits on the effort of a tick.
std::vector<Field> effort_fields() {
  return {number<S, &S::configuration, &SoftConfiguration::newton_iterations>(
              "newton_iterations", by_value, "", {1, 100}, "maximum Newton iterations per tick"),
          number<S, &S::configuration, &SoftConfiguration::solver_iterations>(
              "solver_iterations", by_value, "", {1, 100000},
              "maximum iterations of the linear solver per Newton iteration"),
          number<S, &S::configuration, &SoftConfiguration::solver_tolerance>(
              "solver_tolerance", by_value, "", {0, 0.5, true},
              "relative residual at which the linear solver stops; its square "
              "root if several Newton iterations follow"),
          number<S, &S::configuration, &SoftConfiguration::substeps>("substeps", by_value, "", {1, 1000},
                                                                     "xpbd: substeps per tick"),
          number<S, &S::configuration, &SoftConfiguration::max_substeps>(
              "max_substeps", by_value, "", {1, 100000},
              "explicit integrators: maximum substeps per tick; a body that needs "
              "more is stepped with implicit_euler")};
}

/// Returns the keys of [[soft]] for spring stiffnesses of mass_spring and xpbd.
std::vector<Field> spring_fields() {
  return {number<S, &S::material, &SoftMaterial::spring_stiffness>(
              "spring_stiffness", by_value, "N/m", {0, 1e12},
              "mass_spring, xpbd: stiffness of structural springs; 0: from youngs_modulus"),
          number<S, &S::material, &SoftMaterial::shear_stiffness>(
              "shear_stiffness", by_value, "N/m", {0, 1e12},
              "sheets: stiffness of diagonal springs; 0: from youngs_modulus"),
          number<S, &S::material, &SoftMaterial::bending_stiffness>(
              "bending_stiffness", by_value, "N·m", {0, 1e9},
              "bending stiffness; sheets: Et³/12(1-ν²); ropes: EI, in N·m²; 0: "
              "from youngs_modulus and thickness"),
          plain<S, &S::material, &SoftMaterial::hold_volume>(
              "hold_volume", by_value,
              "mass_spring on tetrahedra: true: adds volume springs that reproduce "
              "poisson_ratio; false: a ratio of about 1/4")};
}

/// Returns the keys of [[soft]] for the server's choice of a model configuration.
std::vector<Field> choice_fields() {
  return {
      quantity<S, &S::choice, &ConfigurationChoice::accuracy>(
          "accuracy", not_hashed, "%", {0, 100, true},
          "solid bodies, instead of an explicit configuration: maximum relative error in each case of "
          "accuracy_of; the server chooses the cheapest configuration that meets it, measured on this "
          "body (docs/understand/soft-tissue.md). Any of model, element, integrator, solver and cell that "
          "is given as well is used unchanged"),
      names<S, &S::choice, &ConfigurationChoice::accuracy_of>(
          "accuracy_of", not_hashed,
          "criteria of accuracy and budget: \"shape\": deformation under its "
          "weight, hung and on its side; \"touch\": indentation by a fingertip"),
      quantity<S, &S::choice, &ConfigurationChoice::budget>(
          "budget", not_hashed, "ms", {0, 1000, true},
          "solid bodies, instead of an explicit configuration: maximum CPU time per frame of 1/60 s; the "
          "server chooses the most accurate configuration within it, as for accuracy"),
      plain<S, &S::choice, &ConfigurationChoice::step_down>(
          "step_down", not_hashed,
          "true: while the server is overloaded, this body may be solved with fewer "
          "iterations or substeps; clients show this")};
}

/// Returns the keys of [[soft]] for the body's figures and its role as a part of the anatomy.
std::vector<Field> part_fields() {
  return {
      plain<S, &S::show_figures>("show_figures", not_hashed,
                                 "true: clients show the body's solver figures above it"),
      plain<S, &S::part>("anatomy", by_value,
                         "true: part of the anatomy: `attach` holds it in place until a user detaches it; "
                         "touching it opens its panel"),
      number<S, &S::snap>(
          "snap", by_value, "m", {0, 1},
          "maximum distance from its original position at which a detached part can be attached again")};
}

/// Adds the keys of [[soft]] for contact, grading and local refinement.
void add_contact(std::vector<Field>& fields) {
  add_collision<S, &S::contact>(
      fields,
      "collision shape: its triangles (mesh); the sphere, box (aabb: along the room's axes; obb: along its "
      "own) or hull around them, refitted in each tick, which cannot be dented; or none");
  fields.push_back(plain<S, &S::contact, &SoftContact::self_contact>(
      "self_contact", by_value, "true: the body collides with itself; collision must be mesh"));
  fields.push_back(words<S, &S::contact, &SoftContact::points>(
      "contact", by_value, {"vertices", "surface", "auto"},
      "contact with rigid bodies; vertices: at the body's vertices; surface: over "
      "the contact area, for solids that collide as mesh and have no substeps; "
      "auto: surface for those, vertices for others"));
  fields.push_back(words<S, &S::geometry, &SoftGeometry::grade>(
      "grade", compiled, {grading_names.begin(), grading_names.end()},
      "rims: smaller elements of a solid where attached and free surface meet, since "
      "stress is largest there (docs/decisions/0026-graded-at-the-rims.md)"));
  fields.push_back(words<S, &S::refinement, &SoftRefinement::at>(
      "refine", by_value, {"none", "touch"},
      "touch: smaller elements of a solid of linear tetrahedra where hands, or bodies that they hold or "
      "push, touch it, until one second after contact (docs/understand/contact.md); not after a cut"));
  fields.push_back(number<S, &S::refinement, &SoftRefinement::cell>(
      "refine_cell", by_value, "m", {0, 1}, "refine: edge length of smaller elements; 0: half of cell"));
  fields.push_back(number<S, &S::refinement, &SoftRefinement::reach>(
      "refine_reach", by_value, "m", {0, 1},
      "refine: distance from the contact within which elements are smaller; 0: as far as `cell`"));
  fields.push_back(number<S, &S::refinement, &SoftRefinement::max_elements>(
      "refine_most", by_value, "", {1, 1000000}, "refine: maximum number of additional elements"));
}

}  // namespace

const Table& soft_table() {
  static const Table table = [] {
    Table t{"[[soft]]",
            "A deformable body. A deformable body's geometry is exactly one of `volume`, `mesh` and `shape`.",
            {},
            {{"curve", soft_curve_table, true, 1, items<S, &S::geometry, &SoftGeometry::curves>},
             {"patch", soft_patch_table, true, 1, items<S, &S::geometry, &SoftGeometry::patches>},
             {"attach", attach_table, true, 64, items<S, &S::attach>},
             {"region", region_table, true, 64, items<S, &S::material, &SoftMaterial::regions>},
             {"relaxation", relaxation_table, true, 8, items<S, &S::material, &SoftMaterial::relaxation>}},
            fresh<S>};
    for (const auto& group :
         {identity_fields(), geometry_fields(), model_fields(), elasticity_fields(), friction_fields(),
          cutting_fields(), effort_fields(), spring_fields(), choice_fields(), part_fields()})
      t.fields.insert(t.fields.end(), group.begin(), group.end());
    add_contact(t.fields);
    add_file_reading<S, &S::geometry>(t.fields);
    add_pose<S>(t.fields, "the mesh's origin, or the volume's or shape's centre, in the room");
    add_fallback_pose<S, &S::geometry>(t.fields);
    add_appearance<S>(t.fields);
    return t;
  }();
  return table;
}

}  // namespace prosector
