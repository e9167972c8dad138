#pragma once
// What the author of a scene wrote, validated. Defaults stand here, in the initialisers, and nowhere else;
// units, ranges and descriptions stand in the field table (scene_fields.cpp), from which the loader, its
// errors and docs/look-up/scene.md come. SI units; orientations as quaternions w, x, y, z; y is up. What a
// scene doesn't name is not modelled.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/hash.h"
#include "common/math.h"
#include "common/mesh.h"
#include "common/messages.h"

namespace prosector {

/// A number written as text with its unit, for instance "4 ms"; in the unit that its field states.
struct Quantity {
  double value = 0;  // 0: not given
  explicit operator bool() const { return value > 0; }
};

/// [[rigid.part]]: one primitive of a rigid body, in the body's frame.
struct PartDesc {
  std::string shape = "box";  // box | sphere | capsule | cylinder | ellipsoid (capsule, cylinder: axis y)
  Vec3 size = {
      0.1, 0.1,
      0.1};   // m: box full extents; sphere: diameter in x; capsule, cylinder: diameter in x, height in y
  Pose pose;  // position, rotation
  double rounding = 0;  // m: radius of the edges, drawn only
};

/// [[rigid.curve]], [[soft.curve]], and the sides of patches, which are given by control points. A Bézier or
/// B-spline curve, rational where it has weights, or an arc of a conic in the x-y plane, for t from `from` to
/// `to`. Conics: ellipse (a cos t, b sin t), parabola (a t², 2 a t), hyperbola (a cosh t, b sinh t).
struct CurveDesc {
  std::string kind = "bspline";  // bezier | bspline | ellipse | parabola | hyperbola
  std::vector<Vec3> points;      // m: control points, of a bezier or bspline
  std::vector<double> weights;   // of the points; empty: all 1
  int degree = 3;                // bspline
  std::vector<double> knots;     // bspline: points + degree + 1; empty: uniform, with ends that are met
  double a = 0.05, b = 0.05;     // m, of a conic
  double from = 0, to = 2 * M_PI;
  Pose pose;                       // of the curve in the body's frame
  double diameter = 2e-3;          // m: of the tube around it
  double tolerance = chord_error;  // m: of the triangles from the true surface, at most
};

/// A piece of a surface over 0 … 1 in u and v: [[rigid.patch]], [[soft.patch]]. It is Bézier or B-spline in
/// both directions, rational where it has weights. Or it is a Coons patch between four sides: along u at v =
/// 0 and at v = 1, then along v at u = 0 and at u = 1. Or it is one side in the x-y plane, turned about y.
struct PatchDesc {
  std::string kind = "bspline";          // bezier | bspline | coons | revolved
  std::vector<Vec3> points;              // m: control points, along u first
  int columns = 4;                       // how many of them along u
  std::vector<double> weights;           // as of CurveDesc
  int degree_u = 3, degree_v = 3;        // bspline
  std::vector<double> knots_u, knots_v;  // bspline: as of CurveDesc
  std::vector<CurveDesc> sides;          // coons, revolved
  Pose pose;                             // in the body's frame
  double thickness = 1e-3;               // m: half on either side
  double tolerance = chord_error;        // m: as of CurveDesc
};

/// [[rigid.fracture]]: a plane along which a bone breaks, in the body's frame.
struct FractureDesc {
  Vec3 point = Vec3::Zero();    // m
  Vec3 normal = Vec3::UnitY();  // any length but zero
};

/// [[rigid.edge]]: a cutting edge, straight, in the body's frame.
struct EdgeDesc {
  Vec3 from = Vec3::Zero();  // m
  Vec3 to = {0, 0, -0.04};   // m
  bool ray = false;          // it cuts sheets only, and meets no resistance
};

inline constexpr std::size_t max_collision_groups = 32;
/// Groups that are there without any body naming them: of bodies that name none, and of people's hands.
inline constexpr const char *default_group = "default", *hand_group = "hand";

/// [[rigid]]: a rigid body.
struct RigidDesc {
  std::string name;
  std::string description;
  std::string parent;    // body it belongs to in the scene graph; empty: the room
  std::string mesh;      // surface file
  std::string volume;    // or a structure of a medical volume, its surface; neither: parts, or curves
  int label = -1;        // as of SoftDesc
  double threshold = 0;  // as of SoftDesc
  double smoothing = 1;  // voxels: as of SoftDesc
  std::string fallback;  // implicit shape (as of SoftDesc) used, with a clear line, when the file is missing
  Vec3 size = {0.1, 0.1, 0.1};      // m: bounding box of the fallback, along its own axes
  Pose fallback_pose;               // of the fallback's centre in the body's frame
  double scale = 1;                 // file units → metres
  Vec3 mesh_origin = Vec3::Zero();  // as of SoftDesc
  Quantity max_volume_error;        // %: as of SoftDesc
  double surface_cell = 0;  // m: triangles' edge length, about; 0: a mesh as it is, a volume's voxel size
  std::vector<PartDesc> parts;
  std::vector<CurveDesc> curves;  // and patches: together they are the body
  std::vector<PatchDesc> patches;
  std::string collision = "hull";  // none | sphere | aabb | obb | hull | mesh
  std::string group = default_group;
  std::vector<std::string> touches;  // groups; empty: all
  bool continuous = false;           // true: found also where it passes through things within a tick
  Pose pose;
  bool fixed = false;     // true: part of the room, never moves
  double density = 1000;  // kg/m³
  double mass = 0;        // kg; 0: from density and volume
  double friction = 0.5;
  double rolling_resistance = 0;  // force that resists free rolling, over the load
  double restitution = 0;
  bool balanced = false;      // on a counterweighted arm: weighs nothing, stays where it is left
  std::string tool = "none";  // none | probe | scalpel: what a hand that grasps it holds
  bool part = false;          // of the anatomy: held to its place until detached; a touch brings up its panel
  double snap = 0.03;         // m: how near to its place a detached part must be to be attached again
  double break_force = 0;     // N across a fracture plane at which it breaks there; 0: never
  std::vector<FractureDesc> fractures;
  std::vector<EdgeDesc> edges;  // that cut tissue while a hand holds the body
  Appearance appearance;
  std::vector<LocalName> names;  // from the scene's labels (LabelTable)
  std::string term;              // as of SceneBody
  bool of_atlas = false;         // a structure of an [[atlas]], which reported on its file
};

/// [[soft.attach]]: tissue that holds the organ to its place. Nodes inside the sphere are tied to their rest
/// position by springs, a Winkler foundation over the tied volume, so that the total does not depend on the
/// mesh. A node that carries V m³ gets stiffness·V N/m. From about 1e12 on it is a pin.
struct AttachDesc {
  Vec3 center = Vec3::Zero();  // m, world frame
  double radius = 0.05;        // m
  double stiffness = 2e5;      // N/m⁴: N/m per m³ of tied tissue
};

/// [[soft.region]]: part of a body that is made of something else: the elements whose middle, at rest, lies
/// inside. Where regions overlap, the last one holds.
struct RegionDesc {
  Vec3 center = Vec3::Zero();           // m, world frame
  double radius = 0.05;                 // m: a sphere's
  Vec3 size = Vec3::Zero();             // m: a box's full extents along the room's axes; zero: a sphere
  double youngs_modulus = 0;            // Pa; 0: the body's
  double poisson_ratio = -1;            // below 0: the body's
  double fiber_stiffness = -1;          // Pa; below 0: the body's
  Vec3 fiber_direction = Vec3::Zero();  // zero: the body's
};

/// [[soft.relaxation]]: one term of a Prony series. Of the stress that a sudden strain raises, this share
/// dies out as e^(−t/time).
struct RelaxationDesc {
  double share = 0.5;
  double time = 1;  // s
};

/// What of a rung the author fixed beside `accuracy` or `budget`; the server chooses the rest.
struct FixedChoice {
  bool model = false, element = false, integrator = false, solver = false, cell = false, grade = false;
};

/// [[soft]]: a deformable body.
struct SoftDesc {
  std::string name;
  std::string description;
  std::string parent;
  std::string volume;    // labelled or grey volume: .inr[.gz], .nii[.gz]
  int label = -1;        // label to take; −1: use threshold
  double threshold = 0;  // grey volumes: inside is above it
  std::string mesh;      // or a tetrahedral mesh: .msh, .vtk
  std::string shape;     // or an implicit shape: liver | kidney | … | block | ball | beam; or sheet | rope
  std::string fallback;  // implicit shape when volume or mesh is missing
  Vec3 size = {0.1, 0.1, 0.1};  // m: implicit shapes and fallbacks: bounding box; sheet: its thickness in y;
                                // rope: its length in x, diameter in y
  Pose fallback_pose;           // of the fallback in the body's frame
  double scale = 1;             // mesh files: file units → metres (volumes carry their voxel size in mm)
  Vec3 mesh_origin = Vec3::Zero();  // file units: point of a mesh file that is the body's origin
  Quantity max_volume_error;        // %: of the filled volume from the file's, beyond which it is refused
  double cell = 0.012;              // m: tetrahedra's edge length, about
  double surface_cell = 0.006;      // m: triangles' edge length of the drawn and touched surface, about
  double smoothing = 1.5;           // voxels: Gaussian σ on the mask before the surface is drawn through it
  Pose pose;                        // volume or mesh frame → room. Volumes: origin at the volume's centre

  std::string model = "fem_corotational";
  std::string element = "tet4";  // tet4: linear | tet10: quadratic, straight-sided at rest
  std::string integrator = "implicit_euler";
  std::string solver = "cg";
  double youngs_modulus = 5400;  // Pa; with [[soft.relaxation]]: at once
  double poisson_ratio = 0.45;
  double fiber_stiffness = 0;            // Pa: what fibres add along themselves in tension
  Vec3 fiber_direction = Vec3::UnitX();  // world frame, at rest; any length but zero
  double density = 1060;                 // kg/m³
  double damping_mass = 0.5;             // 1/s   Rayleigh: C = damping_mass·M + damping_stiffness·K
  double damping_stiffness = 0.01;       // s
  double friction = 0.3;
  double rolling_resistance = 0.1;  // as of RigidDesc; of what collides as a sphere or a hull
  double toughness = 164;          // J/m²: work that a cut takes, for its area; liver's (Gokgol et al. 2012)
  Quantity tension;                // %: by how much less the outermost layer would be by itself
  double tension_depth = 0.01;     // m: thickness of that layer
  std::string collision = "mesh";  // none | sphere | aabb | obb | hull | mesh
  std::string group = default_group;
  std::vector<std::string> touches;  // as of RigidDesc
  bool continuous = false;           // as of RigidDesc
  bool self_contact = false;         // true: it doesn't pass through itself
  std::string contact = "vertices";  // vertices | surface: where rigid things press it
  std::string grade = "none";        // none | rims: elements are smaller at the rim of what holds it
  std::string refine = "none";       // none | touch: elements are smaller where something touches it
  double refine_cell = 0;            // m, as `cell`, of these; 0: half of `cell`
  double refine_reach = 0;           // m: how far from what touches it; 0: `cell`
  int refine_most = 2000;            // elements at most that it has more for that
  bool gravity = true;               // false: the imaged shape already carries it
  int newton_iterations = 3;         // at most, per tick
  int solver_iterations = 60;        // linear solver, at most, per Newton iteration
  double solver_tolerance = 1e-3;    // relative residual at which it stops
  int substeps = 20;                 // xpbd: per tick
  int max_substeps = 400;  // explicit integrators: per tick; a body that needs more is stepped implicitly
  double spring_stiffness = 0;  // mass_spring, xpbd: N/m of each structural spring; 0: from youngs_modulus
  double shear_stiffness = 0;   // sheets: N/m of each diagonal spring; 0: from youngs_modulus
  double bending_stiffness = 0;  // sheets: N·m, D = Et³/12(1−ν²); ropes: N·m², EI; 0: from youngs_modulus
  bool hold_volume = true;       // mass_spring on tetrahedra: meet poisson_ratio; false: about ¼
  // Choosing by need instead of by rung: at most one of the two.
  Quantity accuracy;                                          // %: of error against the continuum
  std::vector<std::string> accuracy_of = {"shape", "touch"};  // what `accuracy` and `budget` are judged by
  Quantity budget;                                            // ms: CPU time a frame of 1/60 s
  FixedChoice fixed;                                          // filled by the loader
  bool step_down = false;          // true: may be solved less exactly while the server is overloaded
  bool show_figures = false;       // true: clients show its live figures above it
  bool part = false;               // as of RigidDesc: what holds it is its `attach`
  double snap = 0.03;              // m, as of RigidDesc
  std::vector<CurveDesc> curves;   // of a rope: the line that it is laid along, at most one
  std::vector<PatchDesc> patches;  // of a sheet: what it is laid over, at most one
  std::vector<AttachDesc> attach;
  std::vector<RegionDesc> regions;
  std::vector<RelaxationDesc> relaxation;
  Appearance appearance = {.surface = Surface::tissue};
  std::vector<LocalName> names;  // as of RigidDesc
  std::string term;
  bool of_atlas = false;  // as of RigidDesc
};

inline constexpr std::size_t max_atlases = 64;
inline constexpr const char* material_by_name = "by name";  // the material that a structure's name tells of

/// [[atlas]]: the structures of a label map, each of which becomes a body (common/anatomy/atlas.h): of bone
/// a rigid one, of anything else a soft one.
struct AtlasDesc {
  std::string volume;                       // label map: as of SoftDesc
  std::string labels;                       // table of its names and colours (LabelTable); empty: by number
  std::vector<std::string> only;            // names; empty: all
  std::vector<std::string> leave_out;       // names
  std::string material = material_by_name;  // of all (common/scene/material.h)
  double cell = 0;                          // m: as of SoftDesc; 0: by the structure's volume
  double surface_cell = 0.005;              // m: as of SoftDesc
  double smoothing = 1.5;                   // voxels: as of SoftDesc
  Quantity max_volume_error;                // %: as of SoftDesc, of each
  std::string model = "fem_corotational";
  std::string element = "tet4";
  std::string integrator = "implicit_euler";
  std::string solver = "cg";
  double hold = 2e5;        // N/m⁴: stiffness of what ties the whole of each to its place; 0: nothing does
  double damping_mass = 4;  // 1/s: as of SoftDesc
  bool gravity = false;
  std::string group = "atlas";  // what lies against each other at rest needs no contacts
  std::vector<std::string> touches = {default_group, hand_group};
  Pose pose;  // of all: as of SoftDesc
};

/// [[light]]: a light.
struct LightDesc : LightInfo {
  std::string carrier;  // name of the body that it goes with; empty: it stays
};

/// [session]: the session's name, whom it admits, and when a hand is let go.
struct SessionDesc {
  std::string name = "prosector";
  int capacity = 64;           // people, observers included
  int observers = 16;          // of them observers, at most
  double input_timeout = 0.5;  // s after which a hand that is no longer tracked is let go
};

/// [hand]: the virtual coupling between a tracked hand and its physical one.
struct HandDesc {
  double mass = 0.4;        // kg
  double stiffness = 2000;  // N/m towards the tracked pose
  double max_force = 40;    // N
  double tear_force = 60;   // N between a hand and what it holds, above which it loses hold
  double friction = 0.6;
};

/// [room]: which sides of the room (common/room.h) collide. People's hands pass through them.
struct RoomDesc {
  bool floor = true;
  bool walls = true;
};

struct SceneDesc {
  std::string name;
  std::string description;
  Vec3 gravity = {0, -9.81, 0};   // m/s²
  double tick_rate = 60;          // Hz
  double contact_stiffness = 20;  // times the soft body's own stiffness over one surface cell
  SessionDesc session;
  HandDesc hand;
  std::optional<RoomDesc> room;  // every scene file has one; none: empty space, for programs of one's own
  CameraInfo camera;
  std::optional<PatientFrame> patient;  // nullopt: nobody lies here
  std::vector<RigidDesc> rigid;
  std::vector<SoftDesc> soft;
  std::vector<AtlasDesc> atlases;
  std::vector<LightDesc> lights;
  std::string labels;  // table of the bodies' names in languages (LabelTable); empty: they have one name

  std::filesystem::path file;  // where it came from, for messages
};

}  // namespace prosector
