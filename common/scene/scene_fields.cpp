#include "common/scene/scene_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/scene/curve_fields.h"
#include "common/scene/field_rows.h"

namespace prosector {
namespace {

constexpr Range unit_interval{0, 1};
constexpr Range density{1, 25000};
constexpr Range friction{0, 10};
constexpr Range scale{0, 1e6, true};

/// Shapes that common/anatomy can make by itself.
std::vector<std::string_view> implicit_shapes() {
  return {"liver", "kidney", "gallbladder", "femur",   "foot",     "block",
          "ball",  "beam",   "cylinder",    "capsule", "horseshoe"};
}

/// Also those that aren't solid.
std::vector<std::string_view> soft_shapes() {
  auto out = implicit_shapes();
  out.insert(out.end(), {"sheet", "rope"});
  return out;
}

/// What rigid and soft bodies have to say about who touches them, and how finely.
template <class Struct>
void add_collision(std::vector<Field>& fields, std::vector<std::string_view> fidelities,
                   std::string_view shape) {
  fields.push_back(words<Struct, &Struct::collision>("collision", std::move(fidelities), shape));
  fields.push_back(name<Struct, &Struct::group>(
      "group", false, "collision group that it belongs to; people's hands are in `hand`"));
  fields.push_back(names<Struct, &Struct::touches>(
      "touches", "groups that it touches, if they touch its own as well; none given: all"));
  fields.push_back(plain<Struct, &Struct::continuous>(
      "continuous",
      "true: what it would pass through within a tick is found, where it first touches "
      "(rigid against soft bodies, and rigid ones of one convex piece)"));
}

/// Where a stand-in goes: a missing file's origin and axes need not be its shape's.
template <class Struct>
void add_fallback_pose(std::vector<Field>& fields) {
  fields.push_back(number<Struct, &Struct::fallback_pose, &Pose::p>(
      "fallback_position", "m", {-10, 10}, "the fallback's centre in the body's frame"));
  fields.push_back(plain<Struct, &Struct::fallback_pose, &Pose::q>(
      "fallback_rotation", "the fallback's orientation in the body's frame, as rotation"));
}

template <class Struct>
void add_appearance(std::vector<Field>& fields) {
  fields.push_back(words<Struct, &Struct::appearance, &Appearance::surface>(
      "surface", {"plain", "tissue", "bone", "metal", "skin", "cloth", "glass", "emissive"},
      "what it is made of, as far as it can be seen; emissive: shines by itself"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::color>("color", "", unit_interval,
                                                                           "linear red, green, blue"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::roughness>("roughness", "", unit_interval,
                                                                               "0 is a mirror, 1 matt"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::wetness>(
      "wetness", "", unit_interval, "0 is dry, 1 a thin film of liquid over the surface"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::refractive_index>(
      "refractive_index", "", {min_refractive_index, max_refractive_index},
      "glass: of light of 587.6 nm (n_d); water 1.33, crown glass 1.52, flint 1.62"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::abbe_number>(
      "abbe_number", "", {min_abbe_number, max_abbe_number},
      "glass: V_d, the lower the more dispersion; crown glass 64, flint 36"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::transmittance>(
      "transmittance", "", unit_interval, "glass: share of red, green, blue light left after 10 mm of it"));
}

// ---- The tables.

const Table& session_table() {
  using S = SessionDesc;
  static const Table table{
      "[session]",
      "Who may be there.",
      {name<S, &S::name>("name", false, "name under which clients find the session"),
       number<S, &S::capacity>("capacity", "people", {1, 1024}, "how many fit, observers included"),
       number<S, &S::observers>("observers", "people", {0, 1024}, "how many of them may be observers"),
       number<S, &S::input_timeout>("input_timeout", "s", {0.05, 60},
                                    "time without input after which a hand is let go")},
      {},
      fresh<S>};
  return table;
}

const Table& hand_table() {
  using H = HandDesc;
  static const Table table{
      "[hand]",
      "The virtual coupling that pulls a physical hand to the tracked one.",
      {number<H, &H::mass>("mass", "kg", {0.01, 10}, "the physical hand's mass"),
       number<H, &H::stiffness>("stiffness", "N/m", {0, 1e5, true}, "of the pull towards the tracked pose"),
       number<H, &H::max_force>("max_force", "N", {0, 1000, true},
                                "bound of that pull; a fifth of it is that of each finger"),
       number<H, &H::tear_force>("tear_force", "N", {0, 1e4, true},
                                 "between a hand and what it holds, above which it loses hold"),
       number<H, &H::friction>("friction", "", friction, "Coulomb coefficient of the skin")},
      {},
      fresh<H>};
  return table;
}

const Table& camera_table() {
  using C = CameraInfo;
  static const Table table{
      "[camera]",
      "Where someone who follows nobody looks from.",
      {number<C, &C::eye>("eye", "m", coordinate, "place of the eye in the room"),
       number<C, &C::target>("target", "m", coordinate, "point that it looks at; not the eye's own place"),
       number<C, &C::fov>("fov", "rad", {0, 3, true}, "vertical field of view")},
      {},
      fresh<C>};
  return table;
}

const Table& part_table() {
  using P = PartDesc;
  static const Table table = [] {
    Table t{"[[rigid.part]]",
            "A primitive of a rigid body; together the parts are what it looks and collides like.",
            {words<P, &P::shape>("shape", {"box", "sphere", "capsule", "cylinder", "ellipsoid"},
                                 "capsule and cylinder stand along y"),
             number<P, &P::size>("size", "m", {0, 100, true},
                                 "box, ellipsoid: full extents; sphere: diameter in x; capsule, cylinder: "
                                 "diameter in x, whole height in y"),
             number<P, &P::rounding>("rounding", "m", {0, 1}, "radius of a box's edges, drawn only")},
            {},
            fresh<P>};
    add_pose<P>(t.fields, "the part's centre in the body's frame");
    return t;
  }();
  return table;
}

const Table& fracture_table() {
  using F = FractureDesc;
  static const Table table{
      "[[rigid.fracture]]",
      "A plane along which the body breaks, when the force that passes through it exceeds `break_force`.",
      {number<F, &F::point>("point", "m", {-10, 10}, "of the plane, in the body's frame"),
       number<F, &F::normal>("normal", "", {-1000, 1000}, "of the plane; any length but zero")},
      {},
      fresh<F>};
  return table;
}

const Table& edge_table() {
  using E = EdgeDesc;
  static const Table table{
      "[[rigid.edge]]",
      "A straight cutting edge. While a hand holds the body, tissue that the edge sweeps through is cut.",
      {number<E, &E::from>("from", "m", {-10, 10}, "one end, in the body's frame"),
       number<E, &E::to>("to", "m", {-10, 10}, "the other end"),
       plain<E, &E::ray>("ray", "a beam: it cuts sheets only, and meets no resistance")},
      {},
      fresh<E>};
  return table;
}

const Table& rigid_table() {
  using R = RigidDesc;
  static const Table table = [] {
    Table t{
        "[[rigid]]",
        "A body that keeps its shape: furniture, instruments, bones, vessels. It has one of "
        "`mesh`, `volume` and parts, or it consists of curves and patches.",
        {name<R, &R::name>("name", true, "unique among all bodies"),
         text<R, &R::description>("description", "for people"),
         name<R, &R::parent>("parent", false,
                             "body that it belongs to in the scene graph; not given: the room"),
         text<R, &R::mesh>("mesh", "surface file: .obj .stl .ply .off .gltf .glb"),
         text<R, &R::volume>("volume", "labelled or grey medical volume: .inr .inr.gz .nii .nii.gz"),
         number<R, &R::label>("label", "", {-1, 65535},
                              "volumes: label to take; -1: what is above threshold"),
         number<R, &R::threshold>("threshold", "", {-1e6, 1e6}, "grey volumes: inside is above it"),
         number<R, &R::smoothing>("smoothing", "voxels", {0, 10}, "volumes: Gaussian σ on the mask"),
         words<R, &R::fallback>("fallback", implicit_shapes(),
                                "implicit shape used, with a clear line, when the file is missing"),
         number<R, &R::size>("size", "m", {0, 10, true}, "bounding box of the fallback, along its own axes"),
         number<R, &R::scale>("scale", "", scale, "file units to metres"),
         number<R, &R::surface_cell>(
             "surface_cell", "m", {0, 1},
             "edge length of the surface, about; 0: a mesh as it is, of a volume the voxel size"),
         plain<R, &R::fixed>("fixed", "true: part of the room, never moves"),
         number<R, &R::density>("density", "kg/m³", density, "of the solid body"),
         number<R, &R::mass>("mass", "kg", {0, 1e6}, "0: from density and volume"),
         number<R, &R::friction>("friction", "", friction, "Coulomb coefficient"),
         number<R, &R::restitution>(
             "restitution", "", unit_interval,
             "0: lands dead, 1: bounces back; on tissue, or among bodies that touch tissue or a hand: as 0"),
         plain<R, &R::balanced>("balanced",
                                "true: on a counterweighted arm: weighs nothing, stays where it is left"),
         words<R, &R::tool>("tool", {"none", "probe", "scalpel"}, "what a hand that grasps it holds"),
         plain<R, &R::part>(
             "anatomy",
             "true: part of the anatomy: held to its place until somebody detaches it; a touch "
             "brings up its panel"),
         number<R, &R::snap>("snap", "m", {0, 1},
                             "how near to its place a detached part must be to be attached again"),
         number<R, &R::break_force>("break_force", "N", {0, 1e6},
                                    "across a fracture plane, at which it breaks there; 0: never")},
        {{"part", part_table, true, 256, append<R, &R::parts>},
         {"curve", rigid_curve_table, true, 256, append<R, &R::curves>},
         {"patch", rigid_patch_table, true, 256, append<R, &R::patches>},
         {"fracture", fracture_table, true, 8, append<R, &R::fractures>},
         {"edge", edge_table, true, 8, append<R, &R::edges>}},
        fresh<R>};
    add_collision<R>(
        t.fields, {"none", "sphere", "aabb", "obb", "hull", "mesh"},
        "what it collides as: its parts, or the hull of its mesh (hull); its parts or triangles "
        "(mesh); one ball (sphere) or box (aabb: along the room's axes where it starts; obb) around "
        "it, that turns along; or nothing");
    add_pose<R>(t.fields, "the body's or mesh's origin in the room");
    add_fallback_pose<R>(t.fields);
    add_appearance<R>(t.fields);
    return t;
  }();
  return table;
}

const Table& attach_table() {
  using A = AttachDesc;
  static const Table table{
      "[[soft.attach]]",
      "Tissue that holds an organ to its place: what lies inside the sphere is tied elastically to where it "
      "rests.",
      {number<A, &A::center>("center", "m", coordinate, "of the sphere, in the room"),
       number<A, &A::radius>("radius", "m", {0, 10, true}, "of the sphere"),
       number<A, &A::stiffness>("stiffness", "N/m per m³", {0, 1e12},
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
      {number<R, &R::center>("center", "m", coordinate, "of the sphere or box, in the room"),
       number<R, &R::radius>("radius", "m", {0, 10, true}, "of the sphere"),
       number<R, &R::size>("size", "m", {0, 10},
                           "full extents of the box along the room's axes; zero: it is a sphere"),
       number<R, &R::youngs_modulus>("youngs_modulus", "Pa", {0, 1e12}, "0: the body's"),
       number<R, &R::poisson_ratio>("poisson_ratio", "", {-1, 0.5, false, true}, "below 0: the body's"),
       number<R, &R::fiber_stiffness>("fiber_stiffness", "Pa", {-1, 1e12}, "below 0: the body's"),
       number<R, &R::fiber_direction>("fiber_direction", "", {-1000, 1000}, "zero: the body's")},
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
      {number<R, &R::share>("share", "", {0, 1, true, true}, "of the stress"),
       number<R, &R::time>("time", "s", {1e-6, 1e6}, "in which it falls to 1/e")},
      {},
      fresh<R>};
  return table;
}

const Table& soft_table() {
  using S = SoftDesc;
  static const Table table = [] {
    Table t{
        "[[soft]]",
        "A body that deforms. Its geometry is exactly one of `volume`, `mesh` and `shape`.",
        {name<S, &S::name>("name", true, "unique among all bodies"),
         text<S, &S::description>("description", "for people"),
         name<S, &S::parent>("parent", false,
                             "body that it belongs to in the scene graph; not given: the room"),
         text<S, &S::volume>("volume", "labelled or grey medical volume: .inr .inr.gz .nii .nii.gz"),
         number<S, &S::label>("label", "", {-1, 65535},
                              "volumes: label to take; -1: what is above threshold"),
         number<S, &S::threshold>("threshold", "", {-1e6, 1e6}, "grey volumes: inside is above it"),
         text<S, &S::mesh>("mesh", "tetrahedral mesh: .msh .vtk"),
         words<S, &S::shape>(
             "shape", soft_shapes(),
             "implicit shape, `size` large; or a sheet in the x-z plane or over a patch, or a rope along "
             "x or a curve, for mass_spring and xpbd"),
         words<S, &S::fallback>(
             "fallback", implicit_shapes(),
             "implicit shape used, with a clear line, when the volume or mesh file is missing"),
         number<S, &S::size>(
             "size", "m", {0, 10, true},
             "bounding box of the implicit shape or fallback; sheet: thickness in y; rope: length "
             "in x, diameter in y"),
         number<S, &S::scale>("scale", "", scale, "mesh files: file units to metres (volumes know theirs)"),
         number<S, &S::cell>("cell", "m", {5e-4, 1},
                             "edge length of the tetrahedra, a sheet's cells or a rope's pieces, about"),
         number<S, &S::surface_cell>("surface_cell", "m", {5e-4, 1},
                                     "edge length of the surface that is touched and drawn, about"),
         number<S, &S::smoothing>("smoothing", "voxels", {0, 10}, "volumes: Gaussian σ on the label's mask"),
         identifier<S, &S::model>("model", "constitutive law, mass_spring or xpbd"),
         words<S, &S::element>(
             "element", {"tet4", "tet10"},
             "tetrahedra: linear, or quadratic (ten nodes: a tenth of the elements for the same error)"),
         identifier<S, &S::integrator>("integrator",
                                       "time integrator, for instance implicit_euler; xpbd has its own"),
         identifier<S, &S::solver>("solver", "linear solver, for instance cg"),
         number<S, &S::youngs_modulus>("youngs_modulus", "Pa", {0, 1e12, true}, "stiffness in tension"),
         number<S, &S::poisson_ratio>("poisson_ratio", "", {0, 0.5, false, true},
                                      "sideways over lengthways strain; towards 0.5 the volume is kept"),
         number<S, &S::fiber_stiffness>("fiber_stiffness", "Pa", {0, 1e12},
                                        "model fem_fibers: what its fibres add along themselves in tension"),
         number<S, &S::fiber_direction>("fiber_direction", "", {-1000, 1000},
                                        "of the fibres at rest, in the room; any length but zero"),
         number<S, &S::density>("density", "kg/m³", density, ""),
         number<S, &S::damping_mass>("damping_mass", "1/s", {0, 1000}, "Rayleigh damping: share of the mass"),
         number<S, &S::damping_stiffness>("damping_stiffness", "s", {0, 10},
                                          "Rayleigh damping: share of the stiffness"),
         number<S, &S::friction>("friction", "", friction, "Coulomb coefficient"),
         number<S, &S::toughness>("toughness", "J/m²", {0, 1e6},
                                  "work that a cut takes, for its area; 0: blades meet no resistance"),
         plain<S, &S::gravity>("gravity", "false: the imaged shape already carries its weight"),
         number<S, &S::newton_iterations>("newton_iterations", "", {1, 100}, "at most, per tick"),
         number<S, &S::solver_iterations>("solver_iterations", "", {1, 100000},
                                          "of the linear solver, at most, per Newton iteration"),
         number<S, &S::solver_tolerance>("solver_tolerance", "", {0, 0.5, true},
                                         "relative residual at which the linear solver stops; its root where "
                                         "several Newton iterations follow"),
         number<S, &S::substeps>("substeps", "", {1, 1000}, "xpbd: per tick"),
         number<S, &S::max_substeps>(
             "max_substeps", "", {1, 100000},
             "explicit integrators: at most, per tick; a body that needs more is stepped by implicit_euler"),
         number<S, &S::spring_stiffness>(
             "spring_stiffness", "N/m", {0, 1e12},
             "mass_spring, xpbd: of each structural spring; 0: from youngs_modulus"),
         number<S, &S::shear_stiffness>("shear_stiffness", "N/m", {0, 1e12},
                                        "sheets: of each diagonal spring; 0: from youngs_modulus"),
         number<S, &S::bending_stiffness>(
             "bending_stiffness", "N·m", {0, 1e9},
             "sheets: Et³/12(1-ν²); ropes: EI, in N·m²; 0: from youngs_modulus and thickness"),
         plain<S, &S::hold_volume>(
             "hold_volume",
             "mass_spring on tetrahedra: volume springs that meet poisson_ratio; false: springs "
             "alone, whose ratio is about 1/4"),
         quantity<S, &S::accuracy>("accuracy", "%", {0, 100, true},
                                   "instead of a rung, for solid bodies: how far the settled shape may be "
                                   "from the continuum's; the "
                                   "server chooses the cheapest rung that its measured table says is good "
                                   "enough (docs/soft-tissue.md). What of "
                                   "model, element, integrator, solver and cell is given beside it is kept"),
         quantity<S, &S::budget>("budget", "ms", {0, 1000, true},
                                 "instead of a rung, for solid bodies: CPU time that the body may take in a "
                                 "frame of 1/60 s; the server chooses "
                                 "the most accurate rung within it, as for accuracy"),
         plain<S, &S::step_down>(
             "step_down",
             "true: while the server is overloaded, this body may be solved with fewer iterations or "
             "substeps; clients are told"),
         plain<S, &S::show_figures>("show_figures", "true: clients show how it is stepped, live, above it"),
         plain<S, &S::part>(
             "anatomy",
             "true: part of the anatomy: `attach` holds it to its place until somebody detaches "
             "it; a touch brings up its panel"),
         number<S, &S::snap>("snap", "m", {0, 1},
                             "how near to its place a detached part must be to be attached again")},
        {{"curve", soft_curve_table, true, 1, append<S, &S::curves>},
         {"patch", soft_patch_table, true, 1, append<S, &S::patches>},
         {"attach", attach_table, true, 64, append<S, &S::attach>},
         {"region", region_table, true, 64, append<S, &S::regions>},
         {"relaxation", relaxation_table, true, 8, append<S, &S::relaxation>}},
        fresh<S>};
    add_collision<S>(
        t.fields, {"none", "sphere", "aabb", "obb", "hull", "mesh"},
        "what it collides as: its triangles (mesh); the ball, box (aabb: along the room's axes; obb: "
        "along its own) or hull around them, fitted anew in each tick, that makes no dents; or nothing");
    t.fields.push_back(plain<S, &S::self_contact>(
        "self_contact", "true: it doesn't pass through itself where it folds; collision must be mesh"));
    add_pose<S>(t.fields, "the mesh's origin, or the volume's or shape's centre, in the room");
    add_fallback_pose<S>(t.fields);
    add_appearance<S>(t.fields);
    return t;
  }();
  return table;
}

const Table& light_table() {
  using L = LightDesc;
  static const Table table{
      "[[light]]",
      "",
      {name<L, &L::name>("name", false, "unique among the lights"),
       words<L, &L::kind>("kind", {"directional", "point", "spot"}, ""),
       name<L, &L::carrier>("body", false,
                            "body that it goes with; position and direction are in its frame then"),
       number<L, &L::position>("position", "m", coordinate, "point, spot: place in the room"),
       number<L, &L::direction>("direction", "", {-1000, 1000},
                                "directional, spot: where the light goes; any length but zero"),
       number<L, &L::color>("color", "", unit_interval, "linear red, green, blue"),
       number<L, &L::intensity>("intensity", "", {0, 1000}, "times the colour"),
       number<L, &L::cone>("cone", "rad", {0, 1.57, true}, "spot: half angle"),
       number<L, &L::softness>("softness", "", unit_interval, "spot: share of the cone over which it fades")},
      {},
      fresh<L>};
  return table;
}

std::string interval(const Range& r) {
  return fmt::format("{}{}, {}{}", r.open_min ? '(' : '[', r.min, r.max, r.open_max ? ')' : ']');
}

}  // namespace

const Table& scene_table() {
  using SD = SceneDesc;
  static const Table table{
      "",
      "Keys at the top of the file, before the first table.",
      {name<SD, &SD::name>("name", true, "the scene's name"),
       text<SD, &SD::description>("description", "for people"),
       number<SD, &SD::gravity>("gravity", "m/s²", {-100, 100}, "y is up"),
       number<SD, &SD::tick_rate>("tick_rate", "Hz", {10, 1000}, "steps per simulated second"),
       number<SD, &SD::contact_stiffness>(
           "contact_stiffness", "", {0, 1e4, true},
           "of contact with a soft body, times that body's own stiffness over one surface cell")},
      {{"session", session_table, false, 1, member<&SD::session>},
       {"hand", hand_table, false, 1, member<&SD::hand>},
       {"camera", camera_table, false, 1, member<&SD::camera>},
       {"rigid", rigid_table, true, max_bodies, append<SD, &SD::rigid>},
       {"soft", soft_table, true, max_bodies, append<SD, &SD::soft>},
       {"light", light_table, true, max_lights, append<SD, &SD::lights>}},
      fresh<SD>};
  return table;
}

std::string allowed(const Field& field, const FieldRef& value) {
  if (!field.words.empty()) return fmt::format("one of: {}", fmt::join(field.words, ", "));
  struct {
    const Field& f;
    std::string operator()(double*) const { return "in " + interval(f.range); }
    std::string operator()(int*) const { return "a whole number in " + interval(f.range); }
    std::string operator()(bool*) const { return "true or false"; }
    std::string operator()(Vec3*) const { return "three numbers in " + interval(f.range); }
    std::string operator()(Quat*) const { return "four numbers [w, x, y, z], not all zero"; }
    std::string operator()(LightKind*) const { return ""; }
    std::string operator()(Surface*) const { return ""; }
    std::string operator()(Quantity*) const {
      return fmt::format("text: a number in {} and its unit, for instance \"2 {}\"", interval(f.range),
                         f.unit);
    }
    std::string operator()(std::vector<std::string>*) const {
      return fmt::format("a list of names, each {} bytes at most", f.max_length);
    }
    std::string operator()(std::vector<double>*) const {
      return fmt::format("a list of numbers in {}, {} at most", interval(f.range), f.max_length);
    }
    std::string operator()(std::vector<Vec3>*) const {
      return fmt::format("a list of [x, y, z] in {}, {} at most", interval(f.range), f.max_length);
    }
    std::string operator()(std::string*) const {
      if (f.text == Text::identifier)
        return "a word of a-z, 0-9 and _ that starts with a letter, at most " + std::to_string(f.max_length);
      const char* what = f.text == Text::name ? "1 to {} bytes of text without control characters"
                                              : "text of at most {} bytes";
      return fmt::format(fmt::runtime(what), f.max_length);
    }
  } describe{field};
  return std::visit(describe, value);
}

}  // namespace prosector
