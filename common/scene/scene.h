#pragma once
// Scene description: the validated content of a scene file. Defaults are the initialisers in this file only.
// Units, ranges and descriptions are in the field table (scene_fields.cpp), which the loader, its error
// messages and docs/look-up/scene.md use. SI units; orientations as quaternions w, x, y, z; y is up. Anything
// that a scene doesn't name is not modelled.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/appearance.h"
#include "common/fidelity.h"
#include "common/hash.h"
#include "common/local_name.h"
#include "common/math.h"
#include "common/mesh.h"

namespace prosector {

/// A number that a scene file gives as text with its unit, for instance "4 ms". It is stored in the unit that
/// its field states.
struct Quantity {
  double value = 0;  // 0: not given
  explicit operator bool() const { return value > 0; }
};

/// [[rigid.part]] of a scene file: one primitive shape of a rigid body, in the body's frame.
struct PartDesc {
  std::string shape = "box";  // box | sphere | capsule | cylinder | ellipsoid (capsule, cylinder: axis y)
  Vec3 size = {
      0.1, 0.1,
      0.1};   // m: box full extents; sphere: diameter in x; capsule, cylinder: diameter in x, height in y
  Pose pose;  // position, rotation
  double rounding = 0;  // m: radius of the rounded edges; affects drawing only
};

/// [[rigid.curve]] or [[soft.curve]] of a scene file, or a side of a surface patch. The curve is a Bézier or
/// B-spline curve with control points, rational if it has weights, or a conic arc. A conic arc is in the x-y
/// plane, for t from `from` to `to`. It is an ellipse (a cos t, b sin t), a parabola (a t², 2 a t) or a
/// hyperbola (a cosh t, b sinh t).
struct CurveDesc {
  std::string kind = "bspline";  // bezier | bspline | ellipse | parabola | hyperbola
  std::vector<Vec3> points;      // m: control points, of a bezier or bspline
  std::vector<double> weights;   // of the points; empty: all 1
  int degree = 3;                // bspline
  std::vector<double> knots;  // bspline: points + degree + 1 values; empty: uniform and clamped at the ends
  double a = 0.05, b = 0.05;  // m, of a conic
  double from = 0, to = 2 * M_PI;
  Pose pose;                       // of the curve in the body's frame
  double diameter = 2e-3;          // m: diameter of the tube around the curve
  double tolerance = chord_error;  // m: maximum distance of the triangles from the exact surface
};

/// [[rigid.patch]] or [[soft.patch]] of a scene file: a surface patch over 0 … 1 in u and v. It is a Bézier
/// or B-spline surface, rational if it has weights, a Coons patch between four sides, or a surface of
/// revolution. A Coons patch has the sides along u at v = 0 and at v = 1, then those along v at u = 0 and at
/// u = 1. A surface of revolution has one side in the x-y plane, rotated about y.
struct PatchDesc {
  std::string kind = "bspline";          // bezier | bspline | coons | revolved
  std::vector<Vec3> points;              // m: control points, u fastest
  int columns = 4;                       // number of control points along u
  std::vector<double> weights;           // as in CurveDesc
  int degree_u = 3, degree_v = 3;        // bspline
  std::vector<double> knots_u, knots_v;  // bspline: as in CurveDesc
  std::vector<CurveDesc> sides;          // coons, revolved
  Pose pose;                             // in the body's frame
  double thickness = 1e-3;               // m: total thickness, half on each side
  double tolerance = chord_error;        // m: as in CurveDesc
};

/// [[rigid.fracture]] of a scene file: a plane along which a bone can break, in the body's frame.
struct FractureDesc {
  Vec3 point = Vec3::Zero();    // m
  Vec3 normal = Vec3::UnitY();  // any length but zero
};

/// [[rigid.edge]] of a scene file: a straight cutting edge of an instrument, in the body's frame.
struct EdgeDesc {
  Vec3 from = Vec3::Zero();  // m
  Vec3 to = {0, 0, -0.04};   // m
  bool ray = false;          // cuts sheets only, without resistance
};

inline constexpr std::size_t max_collision_groups = 32;
/// Names of the predefined collision groups: that of bodies without a group, and that of users' hands.
inline constexpr const char *default_group = "default", *hand_group = "hand";

/// Keys of [[rigid]] that define a rigid body's shape: a file, primitive parts, or curves and patches.
struct RigidGeometry {
  std::string mesh;      // surface file
  std::string volume;    // or the surface of a structure in a medical volume; neither: parts or curves
  int label = -1;        // as in SoftGeometry
  double threshold = 0;  // as in SoftGeometry
  double smoothing = 1;  // voxels: as in SoftGeometry
  std::string fallback;  // implicit shape (as in SoftGeometry) used, and reported, when the file is missing
  Vec3 size = {0.1, 0.1, 0.1};      // m: bounding box of the fallback, along its own axes
  Pose fallback_pose;               // pose of the fallback's centre in the body's frame
  double scale = 1;                 // file units → metres
  Vec3 mesh_origin = Vec3::Zero();  // as in SoftGeometry
  Quantity max_volume_error;        // %: as in SoftGeometry
  double surface_cell = 0;  // m: edge length of the triangles, about; 0: mesh unchanged, volumes: voxel size
  std::vector<PartDesc> parts;
  std::vector<CurveDesc> curves;  // the body is the union of curves and patches
  std::vector<PatchDesc> patches;
};

/// Keys of [[rigid]] for a rigid body's mass.
struct RigidMaterial {
  double density = 1000;  // kg/m³
  double mass = 0;        // kg; 0: from density and volume
};

/// Keys of [[rigid]] for a rigid body's contacts: collision shape, friction, restitution, and the bodies that
/// it collides with.
struct RigidContactDesc {
  Fidelity collision = Fidelity::hull;
  double friction = 0.5;
  double rolling_resistance = 0;  // resisting force in free rolling, over the normal load
  double restitution = 0;
  std::string group = default_group;
  std::vector<std::string> touches;  // groups; empty: all
  bool continuous = false;           // true: continuous collision detection within a tick
};

/// [[rigid]] of a scene file: a rigid body, in groups of keys.
struct RigidDesc {
  std::string name;
  std::string description;
  std::string parent;  // parent body in the scene graph; empty: the room
  Pose pose;
  RigidGeometry geometry;
  RigidMaterial material;
  RigidContactDesc contact;
  bool fixed = false;         // true: part of the room, never moves
  bool balanced = false;      // on a counterweighted arm: weightless, stays where it is left
  std::string tool = "none";  // none | probe | scalpel: kind of tool in the hand that grasps it
  bool part = false;          // anatomical part: held in place until detached; a touch opens its panel
  double snap = 0.03;  // m: maximum distance from its place at which a detached part can be attached again
  double break_force = 0;  // N across a fracture plane at which the body breaks there; 0: never
  std::vector<FractureDesc> fractures;
  std::vector<EdgeDesc> edges;  // edges that cut tissue while a hand holds the body
  Appearance appearance;
  std::vector<LocalName> names;  // from the scene's labels (LabelTable)
  std::string term;              // as in SceneBody
  bool from_atlas = false;       // a structure of an [[atlas]], which has already reported on its file
};

/// [[soft.attach]] of a scene file: attachment of an organ to its surroundings. Springs tie the nodes inside
/// the sphere to their rest positions. They form a Winkler foundation over the tied volume, so that the total
/// stiffness doesn't depend on the mesh. A node with the volume V (m³) gets the stiffness stiffness·V N/m.
/// From about 1e12 on, it acts as a fixed support.
struct AttachDesc {
  Vec3 center = Vec3::Zero();  // m, world frame
  double radius = 0.05;        // m
  double stiffness = 2e5;      // N/m⁴: N/m per m³ of tied tissue
};

/// [[soft.region]] of a scene file: region of a soft body with a different material. It applies to elements
/// whose centroid at rest is inside. Where regions overlap, the last one applies.
struct RegionDesc {
  Vec3 center = Vec3::Zero();           // m, world frame
  double radius = 0.05;                 // m: radius of a sphere
  Vec3 size = Vec3::Zero();             // m: full extents of a box along the room's axes; zero: a sphere
  double youngs_modulus = 0;            // Pa; 0: as the body
  double poisson_ratio = -1;            // below 0: as the body
  double fiber_stiffness = -1;          // Pa; below 0: as the body
  Vec3 fiber_direction = Vec3::Zero();  // zero: as the body
};

/// [[soft.relaxation]] of a scene file: one term of the Prony series of a viscoelastic material. The fraction
/// `share` of the stress after a sudden strain decays as e^(−t/time).
struct RelaxationDesc {
  double share = 0.5;
  double time = 1;  // s
};

/// Where a soft body makes contact with rigid bodies: at the vertices of its surface, or over the area of
/// contact. `automatic`: over the area if the body supports that, else at vertices.
enum class ContactPoints : std::uint8_t { vertices, surface, automatic };

/// Where a solid soft body has smaller elements from the start of a session: nowhere, or at the rims of its
/// attachments.
enum class Grading : std::uint8_t { none, rims };
inline constexpr std::array<std::string_view, 2> grading_names = {"none", "rims"};

/// Where a solid soft body gets smaller elements during a session: nowhere, or where another body touches it.
enum class Refining : std::uint8_t { none, touch };

/// Keys of [[soft]] that define a soft body's shape (a file or an implicit shape) and the sizes of its
/// elements and surface triangles.
struct SoftGeometry {
  std::string volume;    // label map or grey-value volume: .inr[.gz], .nii[.gz]
  int label = -1;        // label of the structure; −1: use threshold
  double threshold = 0;  // grey-value volumes: voxels above it are inside
  std::string mesh;      // or a tetrahedral mesh: .msh, .vtk; or a closed surface to fill
  std::string shape;     // or an implicit shape: liver | kidney | … | block | ball | beam; or sheet | rope
  std::string fallback;  // implicit shape used when the volume or mesh is missing
  Vec3 size = {0.1, 0.1, 0.1};      // m: implicit shapes and fallbacks: bounding box; sheet: thickness in y;
                                    // rope: length in x, diameter in y
  Pose fallback_pose;               // pose of the fallback in the body's frame
  double scale = 1;                 // mesh files: file units → metres (volumes specify their voxel size)
  Vec3 mesh_origin = Vec3::Zero();  // file units: point of a mesh file that becomes the body's origin
  Quantity max_volume_error;        // %: largest accepted difference between the body's volume and the file's
  double cell = 0.012;              // m: approximate edge length of the tetrahedra
  double surface_cell = 0.006;      // m: approximate edge length of the drawn and touched triangles
  double smoothing = 1.5;           // voxels: Gaussian σ applied to the mask before the surface is extracted
  Grading grade = Grading::none;
  std::vector<CurveDesc> curves;   // rope: centre line, at most one
  std::vector<PatchDesc> patches;  // sheet: middle surface, at most one

  bool is_sheet() const { return shape == "sheet"; }
  bool is_rope() const { return shape == "rope"; }
  bool is_solid() const { return !is_sheet() && !is_rope(); }
};

/// Keys of [[soft]] for a soft body's material: elasticity, density, damping, toughness and pre-strain.
struct SoftMaterial {
  double youngs_modulus = 5400;  // Pa; with [[soft.relaxation]]: the instantaneous modulus
  double poisson_ratio = 0.45;
  double fiber_stiffness = 0;            // Pa: additional stiffness along the fibres, in tension
  Vec3 fiber_direction = Vec3::UnitX();  // world frame, at rest; any non-zero length
  double density = 1060;                 // kg/m³
  double damping_mass = 0.5;             // 1/s   Rayleigh: C = damping_mass·M + damping_stiffness·K
  double damping_stiffness = 0.01;       // s
  double toughness = 164;                // J/m²: work of cutting per area; liver's (Gokgol et al. 2012)
  Quantity tension;  // %: by how much less the outermost layer would measure if it were free of stress
  double tension_depth = 0.01;  // m: thickness of that layer
  double spring_stiffness = 0;  // mass_spring, xpbd: N/m of each structural spring; 0: from youngs_modulus
  double shear_stiffness = 0;   // sheets: N/m of each diagonal spring; 0: from youngs_modulus
  double bending_stiffness = 0;  // sheets: N·m, D = Et³/12(1−ν²); ropes: N·m², EI; 0: from youngs_modulus
  bool hold_volume = true;       // mass_spring on tetrahedra: match poisson_ratio; false: about ¼
  std::vector<RegionDesc> regions;
  std::vector<RelaxationDesc> relaxation;
};

/// Keys of [[soft]] for a soft body's model configuration: model, element, integrator, linear solver, and
/// limits on their effort. Model, integrator and solver are names of rows in the tables of
/// server/physics/mechanics/soft.
struct SoftConfiguration {
  std::string model = "fem_corotational";
  std::string element = "tet4";  // tet4: linear | tet10: quadratic, straight-sided at rest
  std::string integrator = "implicit_euler";
  std::string solver = "cg";
  int newton_iterations = 3;       // maximum per tick
  int solver_iterations = 60;      // maximum of the linear solver per Newton iteration
  double solver_tolerance = 1e-3;  // relative residual at which the linear solver stops
  int substeps = 20;               // xpbd: per tick
  int max_substeps = 400;  // explicit integrators: per tick; a body that needs more is integrated implicitly

  bool is_quadratic() const { return element == "tet10"; }
  bool is_position_based() const { return model == "xpbd"; }
};

/// Keys of [[soft]] for a soft body's contacts: collision shape, friction, and the bodies that it collides
/// with.
struct SoftContact {
  Fidelity collision = Fidelity::mesh;
  ContactPoints points = ContactPoints::automatic;
  double friction = 0.3;
  double rolling_resistance = 0.1;  // as in RigidContactDesc; for bodies that collide as a sphere or a hull
  std::string group = default_group;
  std::vector<std::string> touches;  // as in RigidContactDesc
  bool continuous = false;           // as in RigidContactDesc
  bool self_contact = false;         // true: self-collision is detected
};

/// Keys of [[soft]] for local refinement: smaller elements of a solid soft body where another body touches
/// it.
struct SoftRefinement {
  Refining at = Refining::none;
  double cell = 0;          // m: edge length of the smaller elements; 0: half of SoftGeometry::cell
  double reach = 0;         // m: distance from the touching body within which elements are refined; 0: cell
  int max_elements = 2000;  // maximum number of elements that refinement adds
};

/// Properties of a soft body's model configuration that the scene's author fixed in addition to `accuracy` or
/// `budget`. The server chooses the others.
struct FixedConfigurationParts {
  bool model = false, element = false, integrator = false, solver = false, cell = false, grade = false;
};

/// Keys of [[soft]] by which the server chooses a soft body's model configuration: required accuracy or
/// available computing time. At most one of the two is given.
struct ConfigurationChoice {
  Quantity accuracy;                                          // %: error relative to the continuum solution
  std::vector<std::string> accuracy_of = {"shape", "touch"};  // error measures for `accuracy` and `budget`
  Quantity budget;                                            // ms: CPU time per frame of 1/60 s
  FixedConfigurationParts fixed;                              // set by the loader
  bool step_down = false;  // true: solver effort may be reduced while the server is overloaded
};

/// [[soft]] of a scene file: a soft (deformable) body, in groups of keys.
struct SoftDesc {
  std::string name;
  std::string description;
  std::string parent;
  Pose pose;  // volume or mesh frame → room frame. Volumes: origin at the volume's centre
  SoftGeometry geometry;
  SoftMaterial material;
  SoftConfiguration configuration;
  SoftContact contact;
  SoftRefinement refinement;
  ConfigurationChoice choice;
  bool gravity = true;        // false: the imaged shape already includes the effect of gravity
  bool show_figures = false;  // true: clients display its live statistics above it
  bool part = false;          // as in RigidDesc; held in place by its `attach`
  double snap = 0.03;         // m, as in RigidDesc
  std::vector<AttachDesc> attach;
  Appearance appearance = {.surface = Surface::tissue};
  std::vector<LocalName> names;  // as in RigidDesc
  std::string term;
  bool from_atlas = false;  // as in RigidDesc
};

inline constexpr std::size_t max_atlases = 64;
inline constexpr const char* material_by_name = "by name";  // select the material by the structure's name

/// [[atlas]] of a scene file: a label map whose structures become bodies (common/anatomy/atlas.h), rigid ones
/// for bone and soft ones for everything else.
struct AtlasDesc {
  std::string volume;  // label map: as in SoftDesc
  std::string labels;  // table of names and colours (LabelTable); empty: structures are named by number
  std::vector<std::string> only;            // names of the structures to use; empty: all
  std::vector<std::string> leave_out;       // names of the structures to omit
  std::string material = material_by_name;  // of all structures (common/scene/material.h)
  double cell = 0;                          // m: as in SoftDesc; 0: by the structure's volume
  double surface_cell = 0.005;              // m: as in SoftDesc
  double smoothing = 1.5;                   // voxels: as in SoftDesc
  Quantity max_volume_error;                // %: as in SoftDesc, for each structure
  std::string model = "fem_corotational";
  std::string element = "tet4";
  std::string integrator = "implicit_euler";
  std::string solver = "cg";
  double hold = 2e5;  // N/m⁴: stiffness of the springs that hold each whole structure in place; 0: none
  double damping_mass = 4;  // 1/s: as in SoftDesc
  bool gravity = false;
  std::string group = "atlas";  // structures adjacent at rest need no contacts
  std::vector<std::string> touches = {default_group, hand_group};
  Pose pose;  // of all structures: as in SoftDesc
};

/// [[light]] of a scene file: a light, which may be carried by a body.
struct LightDesc : LightInfo {
  std::string carrier;  // name of the body that it moves with; empty: stationary
};

/// [session] of a scene file: the session's name, its capacity, and the hand tracking timeout.
struct SessionDesc {
  std::string name = "prosector";
  int capacity = 64;           // maximum number of participants, observers included
  int observers = 16;          // maximum number of observers
  double input_timeout = 0.5;  // s without tracking after which a hand releases and is removed
};

/// [hand] of a scene file: the virtual coupling that pulls a simulated hand to its tracked pose, with bounded
/// force.
struct HandDesc {
  double mass = 0.4;        // kg
  double stiffness = 2000;  // N/m towards the tracked pose
  double max_force = 40;    // N
  double tear_force = 60;   // N between a hand and a held body, above which the grasp breaks
  double friction = 0.6;
};

/// [room] of a scene file: the sides of the room (common/room.h) that bodies collide with. Users' hands pass
/// through them.
struct RoomDesc {
  bool floor = true;
  bool walls = true;
};

struct SceneDesc {
  std::string name;
  std::string description;
  Vec3 gravity = {0, -9.81, 0};   // m/s²
  double tick_rate = 60;          // Hz
  double contact_stiffness = 20;  // factor on the soft body's own stiffness over one surface cell
  SessionDesc session;
  HandDesc hand;
  std::optional<RoomDesc> room;  // set in every scene file; nullopt: empty space, for scenes made in code
  CameraInfo camera;
  std::optional<PatientFrame> patient;  // nullopt: no patient
  std::vector<RigidDesc> rigid;
  std::vector<SoftDesc> soft;
  std::vector<AtlasDesc> atlases;
  std::vector<LightDesc> lights;
  std::string labels;  // table of the bodies' names in several languages (LabelTable); empty: one name each

  std::filesystem::path file;  // source file, for messages
};

}  // namespace prosector
