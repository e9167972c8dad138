#include "common/scene/body_fields.h"
#include "common/scene/curve_fields.h"

namespace prosector {
namespace {

const Table& part_table() {
  using P = PartDesc;
  static const Table table = [] {
    Table t{"[[rigid.part]]",
            "Each `[[rigid.part]]` table is a primitive shape of a rigid body. All `part` tables of a rigid "
            "body together form its visible shape and its collision shape.",
            {words<P, &P::shape>("shape", compiled, {"box", "sphere", "capsule", "cylinder", "ellipsoid"},
                                 "primitive; the axis of a capsule or cylinder is y"),
             number<P, &P::size>("size", compiled, "m", {0, 100, true},
                                 "box, ellipsoid: full extents; sphere: diameter in x; capsule, cylinder: "
                                 "diameter in x, whole height in y"),
             number<P, &P::rounding>("rounding", compiled, "m", {0, 1},
                                     "edge radius of a box, for rendering only")},
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
      "A `fracture` table is a plane along which the rigid body breaks when the force through the plane "
      "exceeds `break_force`.",
      {number<F, &F::point>("point", by_value, "m", {-10, 10}, "point on the plane, in the body's frame"),
       number<F, &F::normal>("normal", by_value, "", {-1000, 1000},
                             "normal of the plane; any non-zero length")},
      {},
      fresh<F>};
  return table;
}

const Table& edge_table() {
  using E = EdgeDesc;
  static const Table table{
      "[[rigid.edge]]",
      "A straight cutting edge. While a hand holds a rigid body with an `edge` table, the edge cuts tissue "
      "that it sweeps through.",
      {number<E, &E::from>("from", by_value, "m", {-10, 10}, "one end of the edge, in the body's frame"),
       number<E, &E::to>("to", by_value, "m", {-10, 10}, "other end of the edge, in the body's frame"),
       plain<E, &E::ray>("ray", by_value,
                         "true: the edge is a cutting beam: it cuts only sheets, without resistance")},
      {},
      fresh<E>};
  return table;
}

/// Returns the keys of [[rigid]] for the body's name and place in the scene graph.
std::vector<Field> rigid_identity_fields() {
  using R = RigidDesc;
  return {
      name<R, &R::name>("name", by_value, true, "unique among all bodies"),
      text<R, &R::description>("description", not_hashed, "description for users"),
      name<R, &R::parent>("parent", not_hashed, false, "parent body in the scene graph; default: the room")};
}

/// Returns the keys of [[rigid]] for the file or shape that the body's surface is made from.
std::vector<Field> rigid_geometry_fields() {
  using R = RigidDesc;
  return {
      text<R, &R::geometry, &RigidGeometry::mesh>("mesh", compiled,
                                                  "surface file: .obj .stl .ply .off .gltf .glb"),
      text<R, &R::geometry, &RigidGeometry::volume>(
          "volume", compiled, "file of a labelled or grey medical volume: .inr .inr.gz .nii .nii.gz"),
      number<R, &R::geometry, &RigidGeometry::label>(
          "label", compiled, "", {-1, 65535},
          "volumes: label of the body's voxels, not 0; -1: voxels above threshold"),
      number<R, &R::geometry, &RigidGeometry::threshold>(
          "threshold", compiled, "", {-1e6, 1e6},
          "grey volumes: voxels with larger values are inside the body"),
      number<R, &R::geometry, &RigidGeometry::smoothing>("smoothing", compiled, "voxels", {0, 10},
                                                         "volumes: σ of the Gaussian that smooths the mask"),
      words<R, &R::geometry, &RigidGeometry::fallback>(
          "fallback", compiled, implicit_shape_words(),
          "implicit shape used if the file is missing; this is reported"),
      number<R, &R::geometry, &RigidGeometry::size>("size", compiled, "m", {0, 10, true},
                                                    "bounding box of the fallback shape, along its own axes"),
      number<R, &R::geometry, &RigidGeometry::scale>("scale", compiled, "", scale, "file units to metres"),
      number<R, &R::geometry, &RigidGeometry::surface_cell>(
          "surface_cell", compiled, "m", {0, 1},
          "approximate edge length of the surface; 0: mesh unchanged, volumes: voxel size")};
}

/// Returns the keys of [[rigid]] for mass, friction, restitution and support.
std::vector<Field> rigid_motion_fields() {
  using R = RigidDesc;
  return {plain<R, &R::fixed>("fixed", by_value, "true: the body is part of the room, never moves"),
          number<R, &R::material, &RigidMaterial::density>("density", compiled, "kg/m³", density,
                                                           "density of the solid body"),
          number<R, &R::material, &RigidMaterial::mass>("mass", compiled, "kg", {0, 1e6},
                                                        "0: from density and volume"),
          number<R, &R::contact, &RigidContactDesc::friction>("friction", by_value, "", friction,
                                                              "Coulomb coefficient"),
          number<R, &R::contact, &RigidContactDesc::rolling_resistance>(
              "rolling_resistance", by_value, "", unit_interval,
              "rolling resistance force divided by load; not applied on "
              "deformable tissue, whose damping resists rolling"),
          number<R, &R::contact, &RigidContactDesc::restitution>(
              "restitution", by_value, "", unit_interval,
              "coefficient of restitution, 0: no bounce, 1: elastic; treated as 0 on "
              "tissue, and among bodies that touch tissue or a hand"),
          plain<R, &R::balanced>("balanced", by_value,
                                 "true: on a counterweighted arm: weightless, stays where it is released")};
}

/// Returns the keys of [[rigid]] for what users do with the body: hold it as a tool, detach it, break it.
std::vector<Field> rigid_role_fields() {
  using R = RigidDesc;
  return {words<R, &R::tool>("tool", not_hashed, {"none", "probe", "scalpel"},
                             "kind of tool that the body is in a grasping hand"),
          plain<R, &R::part>("anatomy", by_value,
                             "true: part of the anatomy: held in place until a user detaches it; touching it "
                             "opens its panel"),
          number<R, &R::snap>(
              "snap", by_value, "m", {0, 1},
              "maximum distance from its original position at which a detached part can be attached again"),
          number<R, &R::break_force>("break_force", by_value, "N", {0, 1e6},
                                     "force through a fracture plane at which the body breaks; 0: never")};
}

}  // namespace

const Table& rigid_table() {
  using R = RigidDesc;
  static const Table table = [] {
    Table t{
        "[[rigid]]",
        "Each `[[rigid]]` table is a rigid body: a piece of furniture, an instrument, a bone, a vessel. A "
        "rigid body's geometry is one of `mesh`, `volume`, `part` tables, or `curve` and `patch` tables.",
        {},
        {{"part", part_table, true, 256, items<R, &R::geometry, &RigidGeometry::parts>},
         {"curve", rigid_curve_table, true, 256, items<R, &R::geometry, &RigidGeometry::curves>},
         {"patch", rigid_patch_table, true, 256, items<R, &R::geometry, &RigidGeometry::patches>},
         {"fracture", fracture_table, true, 8, items<R, &R::fractures>},
         {"edge", edge_table, true, 8, items<R, &R::edges>}},
        fresh<R>};
    for (const auto& group :
         {rigid_identity_fields(), rigid_geometry_fields(), rigid_motion_fields(), rigid_role_fields()})
      t.fields.insert(t.fields.end(), group.begin(), group.end());
    add_collision<R, &R::contact>(
        t.fields,
        "collision shape; hull: the body's parts, or its mesh's convex hull; mesh: its parts or triangles; "
        "sphere, aabb, obb: one sphere or box that rotates with it (aabb: along the room's axes at start)");
    add_file_reading<R, &R::geometry>(t.fields);
    add_pose<R>(t.fields, "the body's or mesh's origin in the room");
    add_fallback_pose<R, &R::geometry>(t.fields);
    add_appearance<R>(t.fields);
    return t;
  }();
  return table;
}

}  // namespace prosector
