#include "common/scene/body_fields.h"
#include "common/scene/curve_fields.h"

namespace prosector {
namespace {

const Table& part_table() {
  using P = PartDesc;
  static const Table table = [] {
    Table t{
        "[[rigid.part]]",
        "A primitive of a rigid body; together the parts are what it looks and collides like.",
        {words<P, &P::shape>("shape", compiled, {"box", "sphere", "capsule", "cylinder", "ellipsoid"},
                             "capsule and cylinder stand along y"),
         number<P, &P::size>("size", compiled, "m", {0, 100, true},
                             "box, ellipsoid: full extents; sphere: diameter in x; capsule, cylinder: "
                             "diameter in x, whole height in y"),
         number<P, &P::rounding>("rounding", compiled, "m", {0, 1}, "radius of a box's edges, drawn only")},
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
      {number<F, &F::point>("point", by_value, "m", {-10, 10}, "of the plane, in the body's frame"),
       number<F, &F::normal>("normal", by_value, "", {-1000, 1000}, "of the plane; any length but zero")},
      {},
      fresh<F>};
  return table;
}

const Table& edge_table() {
  using E = EdgeDesc;
  static const Table table{
      "[[rigid.edge]]",
      "A straight cutting edge. While a hand holds the body, tissue that the edge sweeps through is cut.",
      {number<E, &E::from>("from", by_value, "m", {-10, 10}, "one end, in the body's frame"),
       number<E, &E::to>("to", by_value, "m", {-10, 10}, "the other end"),
       plain<E, &E::ray>("ray", by_value, "a beam: it cuts sheets only, and meets no resistance")},
      {},
      fresh<E>};
  return table;
}

}  // namespace

const Table& rigid_table() {
  using R = RigidDesc;
  static const Table table = [] {
    Table t{
        "[[rigid]]",
        "A body that keeps its shape: furniture, instruments, bones, vessels. It has one of "
        "`mesh`, `volume` and parts, or it consists of curves and patches.",
        {name<R, &R::name>("name", by_value, true, "unique among all bodies"),
         text<R, &R::description>("description", not_hashed, "for people"),
         name<R, &R::parent>("parent", not_hashed, false,
                             "body that it belongs to in the scene graph; not given: the room"),
         text<R, &R::mesh>("mesh", compiled, "surface file: .obj .stl .ply .off .gltf .glb"),
         text<R, &R::volume>("volume", compiled,
                             "labelled or grey medical volume: .inr .inr.gz .nii .nii.gz"),
         number<R, &R::label>("label", compiled, "", {-1, 65535},
                              "volumes: label to take, not 0; -1: what is above threshold"),
         number<R, &R::threshold>("threshold", compiled, "", {-1e6, 1e6}, "grey volumes: inside is above it"),
         number<R, &R::smoothing>("smoothing", compiled, "voxels", {0, 10},
                                  "volumes: Gaussian σ on the mask"),
         words<R, &R::fallback>("fallback", compiled, implicit_shape_words(),
                                "implicit shape used, with a clear line, when the file is missing"),
         number<R, &R::size>("size", compiled, "m", {0, 10, true},
                             "bounding box of the fallback, along its own axes"),
         number<R, &R::scale>("scale", compiled, "", scale, "file units to metres"),
         number<R, &R::surface_cell>(
             "surface_cell", compiled, "m", {0, 1},
             "edge length of the surface, about; 0: a mesh as it is, of a volume the voxel size"),
         plain<R, &R::fixed>("fixed", by_value, "true: part of the room, never moves"),
         number<R, &R::density>("density", compiled, "kg/m³", density, "of the solid body"),
         number<R, &R::mass>("mass", compiled, "kg", {0, 1e6}, "0: from density and volume"),
         number<R, &R::friction>("friction", by_value, "", friction, "Coulomb coefficient"),
         number<R, &R::rolling_resistance>("rolling_resistance", by_value, "", unit_interval,
                                           "force that resists free rolling, over the load; not of what "
                                           "touches deformable tissue, whose own damping resists"),
         number<R, &R::restitution>(
             "restitution", by_value, "", unit_interval,
             "0: lands dead, 1: bounces back; on tissue, or among bodies that touch tissue or a hand: as 0"),
         plain<R, &R::balanced>("balanced", by_value,
                                "true: on a counterweighted arm: weighs nothing, stays where it is left"),
         words<R, &R::tool>("tool", not_hashed, {"none", "probe", "scalpel"},
                            "what a hand that grasps it holds"),
         plain<R, &R::part>(
             "anatomy", by_value,
             "true: part of the anatomy: held to its place until somebody detaches it; a touch "
             "brings up its panel"),
         number<R, &R::snap>("snap", by_value, "m", {0, 1},
                             "how near to its place a detached part must be to be attached again"),
         number<R, &R::break_force>("break_force", by_value, "N", {0, 1e6},
                                    "across a fracture plane, at which it breaks there; 0: never")},
        {{"part", part_table, true, 256, items<R, &R::parts>},
         {"curve", rigid_curve_table, true, 256, items<R, &R::curves>},
         {"patch", rigid_patch_table, true, 256, items<R, &R::patches>},
         {"fracture", fracture_table, true, 8, items<R, &R::fractures>},
         {"edge", edge_table, true, 8, items<R, &R::edges>}},
        fresh<R>};
    add_collision<R>(
        t.fields, {"none", "sphere", "aabb", "obb", "hull", "mesh"},
        "what it collides as: its parts, or the hull of its mesh (hull); its parts or triangles "
        "(mesh); one ball (sphere) or box (aabb: along the room's axes where it starts; obb) around "
        "it, that turns along; or nothing");
    add_file_reading<R>(t.fields);
    add_pose<R>(t.fields, "the body's or mesh's origin in the room");
    add_fallback_pose<R>(t.fields);
    add_appearance<R>(t.fields);
    return t;
  }();
  return table;
}

}  // namespace prosector
