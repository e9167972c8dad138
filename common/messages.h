#pragma once
// What travels between server and clients, as plain data. `idl/` turns each into its wire form and back, with
// all checks; nobody else knows DDS. Units: SI, seconds, metres, newtons, radians; colours are linear RGB in
// [0, 1]. Directions and QoS: docs/look-up/topics.md. Limits that the edge enforces stand here, beside the
// field they bound.

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/contact_plane.h"
#include "common/hash.h"
#include "common/local_name.h"
#include "common/math.h"

namespace prosector {

inline constexpr std::uint32_t protocol_version = 10;

using ParticipantId = std::uint64_t;  // drawn at random by each client; 0 is nobody
using BodyId = std::uint32_t;         // index into SceneInfo::bodies

enum class Role : std::uint8_t { observer, dissector, host };
/// Journals and peers keep these numbers: new ones come at the end.
enum class Gesture : std::uint8_t {
  none,
  fist,
  point,
  two,
  three,
  little,
  index_little,
  flat,
  pinch,
  thumb_up,
  thumb_index,
  four
};

inline constexpr std::size_t max_name_length = 63;      // bytes, UTF-8: session, participant, body names
inline constexpr std::size_t max_text_length = 1023;    // bytes: descriptions, reasons
inline constexpr std::size_t max_language_length = 35;  // bytes: a language tag (RFC 5646, 4.4.1)
inline constexpr std::size_t max_local_names = 16;      // of one body
inline constexpr std::size_t max_term_length = 31;      // bytes: an entry of Terminologia Anatomica
inline constexpr std::size_t max_bodies = 4096;
inline constexpr std::size_t max_lights = 16;
inline constexpr std::size_t max_streamed_points = 1024 * 1024;  // of one soft body
inline constexpr std::size_t max_holders = 64;                   // hands on one body that are told of
inline constexpr double max_coordinate = 1000.0;  // metres: a pose farther out is not a pose in this room
inline constexpr std::size_t fingers = 5;         // thumb, index, middle, ring, little

/// Simulated time. A rewind starts a new epoch, so (epoch, tick) never repeats.
struct SimTime {
  std::uint32_t epoch = 0;
  std::uint64_t tick = 0;
  auto operator<=>(const SimTime&) const = default;
};

/// server → all; the first thing a client reads, and enough to refuse with a clear message.
struct SessionInfo {
  std::uint32_t version = protocol_version;
  std::string session;           // also the DDS partition
  std::string scene;             // the scene's name
  ContentHash scene_hash{};      // of the compiled scene: geometry, materials, settings
  double tick_rate = 60;         // Hz
  std::uint32_t capacity = 0;    // people that fit, observers included
  std::uint64_t server_run = 0;  // differs from run to run: a client that sees it change starts over
};

/// participant → server; written once, liveliness 1 s. Disposal or loss of liveliness is leaving.
struct Presence {
  ParticipantId participant = 0;
  std::uint32_t version = protocol_version;
  std::string name;
  Role role = Role::observer;  // what the participant asks for; the server's Roster says what it got
  std::string devices;         // for people: "fastrak, 5dt-serial"
  std::uint8_t arms = 0;       // hands that are moved by a haptic arm: bit 0 the left one, bit 1 the right
};

/// server → all; one per participant, removed (disposed) when it leaves.
struct RosterEntry {
  ParticipantId participant = 0;
  std::string name;
  Role role = Role::observer;
  Vec3 color = Vec3::Ones();
  std::string devices;
};

/// Bit of HandPose::buttons: the hand draws a cut, from when a button goes down for it until its blade is
/// out. The lower bits are devices' own.
inline constexpr std::uint32_t draws_cut = 1u << 31;

struct HandPose {
  bool tracked = false;  // false: no pose this time; the server holds the last for a while
  Pose pose;             // wrist in the room: −z towards the fingers, +y out of the back of the hand
  std::array<double, fingers> flexion{};  // 0 open … 1 closed fist, thumb first
  Gesture gesture = Gesture::none;
  std::uint32_t buttons = 0;  // bit per button, and draws_cut
};

inline constexpr std::size_t left_hand = 0, right_hand = 1;

/// What is tracked in a user's hand, beside the hands themselves.
enum class HeldThing : std::uint8_t {
  tablet,  // the user's panel: its pose is the board's middle, +x right, +y up, +z towards the reader
  stylus   // its pose is the tip, +z along the shaft
};
inline constexpr std::size_t held_things = 2;

struct HeldPose {
  bool tracked = false;
  Pose pose;  // in the room
};

/// participant → server, best effort, 120 Hz. Dropped by role: an observer's changes nothing.
struct HandInput {
  ParticipantId participant = 0;
  std::uint64_t sequence =
      0;  // rises by one a sample; the journal keys inputs by (tick, participant, sequence)
  std::int64_t time_ns = 0;  // sender's monotonic clock when the device's record began; informative
  bool head_tracked = false;
  Pose head;  // eyes in the room: −z looks ahead
  std::array<HandPose, 2> hands{};
  std::array<HeldPose, held_things> held{};  // in the order of HeldThing
};

/// server → all, best effort: where everyone is, as the server has it.
struct UserState {
  ParticipantId participant = 0;
  SimTime time;
  std::uint64_t input_sequence = 0;  // the last HandInput consumed
  bool head_tracked = false;
  Pose head;
  std::array<HandPose, 2>
      hands{};  // where the physical hand is, which may rest on things short of its target
};

enum class CommandKind : std::uint8_t {
  join,
  grasp,  // what is nearest to the hand; with the `revision` grasps_body: rather `body`, if it is in reach
  release,
  reset,  // put `body` back to rest, in its place, as the scene has it
  leave,
  set_role,  // by the host: `subject` becomes `role`; handing over `host` makes the sender a dissector
  detach,    // take the part `body` out of the anatomy
  attach,    // put it back, where it is near enough to its place
  inspect,   // show `body` as `shape` would have it: moved, turned, scaled, sheared; out of everyone's touch
  end_inspect,
  open_panel,  // of the part `body`, as a touch does; of an open one: common/panel_placing.h
  close_panel,
  set_control,  // of the sender's open panel, as a finger does: `control` to `value`
  undo,         // the sender's last cut
  rewind,       // by the host: everything as it was when `body` got its `revision`
  keyframe,    // by anyone, observers too: what the sender holds of `body` doesn't fit its log; send it whole
  set_pace,    // by the host: `value` simulated seconds a real one: 0, or least_pace … 1
  step_ticks,  // by the host: time stands still, but for `revision` ticks, 1 … most_steps
  reset_all,   // by the host: everything as it was when the server began
  seek,        // of a recording that is watched: to what was at the end of the tick `revision`
  set_effort,  // by the host: from now on `body` is solved `revision` steps less exactly, 0 … max_steps_down
  set_all_efforts,  // by the host: so is every deformable
  // By the host: `body` is modelled anew, the cheapest way within `value` %. With 0 nothing changes, but its
  // BodyStatus tells from now on what it can have.
  set_accuracy
};
inline constexpr CommandKind last_command = CommandKind::set_accuracy;
inline constexpr double least_pace = 1.0 / 64, most_pace = 8;  // above 1: of a recording that is watched
inline constexpr std::uint32_t most_steps = 6000;
inline constexpr double least_accuracy = 0.1, most_accuracy = 100;  // %

/// What a part's panel has, in the order of the table in common/panel.h.
enum class PanelControl : std::uint8_t {
  attach,        // button: in its place, or free
  hide_others,   // button
  transparency,  // button: opaque, or half seen through
  light_shaft,   // button: the lamp's light falls on the part
  room_lights,   // button: bright, or dimmed
  stiffness      // slider: ¼ … 4 times the scene's, ½ is 1
};
inline constexpr std::size_t panel_control_count = 6;

/// participant → server, reliable; each is answered by one CommandResult with the same participant and
/// sequence.
struct Command {
  ParticipantId participant = 0;
  std::uint64_t sequence = 0;
  CommandKind kind = CommandKind::join;
  std::uint8_t hand = right_hand;  // for grasp and release
  BodyId body = 0;  // what it is about: reset, detach, attach, inspect, open_panel, rewind, keyframe, set_…
  ParticipantId subject = 0;   // for set_role
  Role role = Role::observer;  // for set_role
  Affine shape;  // for inspect: from where the body's points are without it to where they are seen
  PanelControl control = PanelControl::attach;  // for set_control
  double value = 0;  // for set_control: button 0 off, 1 on; slider 0 … 1. For set_pace, set_accuracy
  std::uint32_t revision = 0;  // for rewind, step_ticks, seek, set_effort…, open_panel and grasp
};

struct CommandResult {
  ParticipantId participant = 0;
  std::uint64_t sequence = 0;
  bool accepted = false;
  std::string reason;  // why not; empty when accepted
};

enum class BodyKind : std::uint8_t { rigid, soft };

/// What an object collides as, coarsest first (docs/understand/collision.md).
enum class Fidelity : std::uint8_t { none, sphere, aabb, obb, hull, mesh };

/// What a surface is made of, as far as it can be seen. The last three are the client's own room.
enum class Surface : std::uint8_t {
  plain,
  tissue,
  bone,
  metal,
  skin,
  cloth,
  glass,
  emissive,
  floor,
  wall,
  ceiling
};
inline constexpr Surface last_body_surface = Surface::emissive, last_surface = Surface::ceiling;

inline constexpr double min_refractive_index = 1, max_refractive_index = 4;
inline constexpr double min_abbe_number = 10, max_abbe_number = 1000;

/// What a body looks like; enough for a renderer to choose its material.
struct Appearance {
  Vec3 color = {0.7, 0.7, 0.7};
  double roughness = 0.6;  // 0 mirror … 1 matt
  double wetness = 0;      // 0 dry … 1: a thin film of liquid over the surface
  Surface surface = Surface::plain;
  // Glass only, which has no `color`; at first a crown glass (BK7) with the green of window panes.
  double refractive_index = 1.5168;  // n_d: of light of 587.6 nm
  double abbe_number = 64.17;        // V_d = (n_d − 1)/(n_F − n_C): the lower, the more dispersion
  Vec3 transmittance = {0.975, 0.99, 0.985};  // share of red, green, blue left after 10 mm of it
  bool operator==(const Appearance&) const = default;
};

struct SceneBody {
  std::string name;
  std::string description;
  BodyKind kind = BodyKind::rigid;
  std::int32_t parent = -1;  // body that it belongs to in the scene graph, −1: the room
  bool moves = false;        // false: never in RigidState
  Pose pose;                 // at scene start (rigid) / body frame of quantisation (soft)
  ContentHash mesh{};  // Asset: triangle surface, in the body's frame (rigid) or the room's rest shape (soft)
  ContentHash map{};   // Asset; soft: StreamedSurface (common/asset.h), rigid: ends of cutting edges
  std::uint32_t points = 0;        // soft only: how many points are streamed
  std::uint32_t chunk_points = 0;  // soft only: points per SoftState chunk (the last may hold fewer)
  double tube_diameter = 0;        // m: soft without triangles, whose vertices in order are a tube's axis
  Appearance appearance;
  std::string method;         // soft only, for people: how it is simulated, and why so if the server chose
  bool show_figures = false;  // soft only: show its BodyStatus above it
  bool part = false;          // of the anatomy: a touch brings up its panel
  Fidelity fidelity = Fidelity::mesh;  // what it collides as
  ContentHash
      outline{};  // Asset: what it collides as, in the frame of `mesh`; zero: nothing, or `mesh` itself
  std::vector<LocalName> names;  // `name` in other languages, each language once
  std::string term;              // entry of Terminologia Anatomica (1998): "A05.8.01.001"; empty: none
};

enum class LightKind : std::uint8_t { directional, point, spot };

struct LightInfo {
  std::string name;
  LightKind kind = LightKind::point;
  Vec3 position = Vec3::Zero();
  Vec3 direction = {0, -1, 0};
  Vec3 color = Vec3::Ones();
  double intensity = 1;
  double cone = 0.5;       // spot: half angle, rad
  double softness = 0.2;   // spot: share of the cone over which it fades
  std::int32_t body = -1;  // whose frame position and direction are in, and with which it goes; −1: the room
};

struct CameraInfo {
  Vec3 eye = {0, 1.6, 1.2};
  Vec3 target = {0, 1, 0};
  double fov = 0.8;  // vertical, rad
};

/// How the patient whose organs are shown lies in the room: directions in the world frame, of any length but
/// zero, perpendicular to each other.
struct PatientFrame {
  Vec3 right = -Vec3::UnitX();  // towards the patient's right
  Vec3 head = -Vec3::UnitZ();   // from the feet towards the head (superior)

  /// Returns the unit direction towards the patient's front (anterior).
  Vec3 front() const { return head.cross(right).normalized(); }
};
inline constexpr double least_patient_angle = 1.55;  // rad between `right` and `head`

/// Tells whether the two directions are finite, not zero, and perpendicular but for rounding.
inline bool is_frame(const PatientFrame& frame) {
  const double area = frame.head.cross(frame.right).norm(), lengths = frame.head.norm() * frame.right.norm();
  return std::isfinite(lengths) && lengths > 0 && area >= std::sin(least_patient_angle) * lengths;
}

/// server → all, reliable, transient-local: the scene graph. Meshes follow as Assets.
struct SceneInfo {
  std::string name;
  std::string description;
  std::vector<SceneBody> bodies;
  std::vector<LightInfo> lights;
  CameraInfo camera;
  std::optional<PatientFrame> patient;  // nullopt: the scene has none
};

inline constexpr std::size_t asset_chunk_bytes = 256 * 1024;
inline constexpr std::size_t max_asset_bytes = 256u * 1024 * 1024;

/// server → all, reliable, transient-local, keyed (hash, chunk): clients need no files.
struct AssetChunk {
  ContentHash hash{};
  std::uint32_t chunk = 0;
  std::uint32_t chunks = 0;
  std::uint32_t total_bytes = 0;
  std::vector<std::uint8_t> bytes;  // asset_chunk_bytes each, the last one shorter
};

/// server → all, best effort, keyed by body: only what moves.
struct RigidState {
  BodyId body = 0;
  SimTime time;
  Pose pose;
  Vec3 linear_velocity = Vec3::Zero();   // m/s
  Vec3 angular_velocity = Vec3::Zero();  // rad/s
  bool settled = false;                  // last sample before sleep
};

inline constexpr std::size_t max_chunk_points = 256;
inline constexpr double max_tube_diameter = 10;        // m, as much as a scene may ask for
inline constexpr std::size_t soft_chunk_points = 112;  // what a server uses: one datagram, ≤ 1,200 bytes

/// server → all, best effort, keyed (body, chunk): some streamed points, whole in itself, so one lost
/// datagram costs one chunk. On the wire quantised within the chunk's own box; here decoded.
struct SoftState {
  BodyId body = 0;
  std::uint32_t chunk = 0;
  SimTime time;
  std::uint32_t revision = 0;  // topology revision that the points belong to
  std::uint32_t first_point = 0;
  std::vector<Vec3> positions;   // metres, from the points' places at rest (StreamedSurface)
  std::vector<Vec3> velocities;  // m/s, coarse: for Hermite interpolation
};

/// server → all, reliable, transient-local, keyed by body: a body went to sleep here, at full precision. So a
/// lost last chunk never stays wrong and a late joiner has the rest shape.
struct Settled {
  BodyId body = 0;
  SimTime time;
  std::uint32_t revision = 0;
  std::uint64_t hash = 0;                  // StateHasher over the float positions
  std::vector<Eigen::Vector3f> positions;  // all streamed points, metres, world frame
};

/// What made a revision of a body's topology.
enum class TopologyCause : std::uint8_t { compiled, cut, undo, rewind };

inline constexpr std::size_t max_surface_vertices = 1024 * 1024;       // slots of one soft body
inline constexpr std::size_t max_surface_triangles = 2 * 1024 * 1024;  // slots of one soft body

/// What a revision changed of the surface that is drawn. Streamed points, vertices and triangles have slots,
/// numbers that are never used again. A change only sets some slots and appends others. What is gone stays as
/// a slot that nothing uses; such a triangle has its corners equal. Numbers are floats, so that every end
/// holds the same bits.
struct SurfacePatch {
  struct Point {                                     // appended, in order
    Eigen::Vector3f rest = Eigen::Vector3f::Zero();  // m, world frame: what SoftState's positions start from
    Eigen::Vector3f now = Eigen::Vector3f::Zero();   // m, world frame, at the revision's time
  };
  struct Vertex {
    std::uint32_t slot = 0;
    Eigen::Vector3f rest = Eigen::Vector3f::Zero();  // m, world frame
    std::array<std::uint32_t, 4> point{};            // that it hangs on; unused entries: weight 0
    std::array<float, 4> weight{};                   // sum 1
  };
  struct Triangle {
    std::uint32_t slot = 0;
    std::array<std::uint32_t, 3> corners{};  // vertex slots
    bool inner = false;                      // a cut laid it bare
  };
  std::vector<Point> points;
  std::vector<Vertex> vertices;     // by slot, ascending
  std::vector<Triangle> triangles;  // by slot, ascending
};

/// server → all, reliable, transient-local, keyed by (body, revision): the ordered log of topology. A soft
/// body's first revision is that of the compiled scene, or of the cut that made it a body; later ones chain
/// to it. A revision with a keyframe can be entered without those before it, which are no longer kept then.
struct TopologyRevision {
  BodyId body = 0;
  std::uint32_t revision = 0;
  std::uint64_t previous_hash = 0;  // chain hash of revision − 1 (0 for the first)
  std::uint64_t chain_hash = 0;     // chain_hash_of(): common/surface_patch.h
  std::uint64_t content_hash = 0;   // connectivity, rest shape, masses
  SimTime time;                     // of the tick that made it
  TopologyCause cause = TopologyCause::compiled;
  ParticipantId author = 0;        // who cut, undid or rewound; 0: nobody
  std::int32_t piece_of = -1;      // body that it was cut off; −1: none
  std::uint64_t surface_hash = 0;  // of the slots with this revision
  SurfacePatch patch;              // from the revision before
  ContentHash mesh{}, map{};       // keyframe: Assets, as SceneBody's, of all slots; zero: none

  bool keyframe() const { return mesh != ContentHash{}; }
};

/// server → all, best effort, keyed by (participant, hand): what a hand touches most, or meets first.
struct ContactSample {
  ParticipantId participant = 0;
  std::uint8_t hand = right_hand;
  SimTime time;
  bool touching = false;
  BodyId body = 0;
  Vec3 point = Vec3::Zero();        // world frame
  Vec3 normal = {0, 1, 0};          // out of the touched body
  double depth = 0;                 // metres, > 0 penetrates, < 0 a gap
  double impulse = 0;               // N·s over the last tick, all contacts of this hand
  Vec3 local_point = Vec3::Zero();  // `point` in the touched body's frame; soft: where it is at rest
  Vec3 force = Vec3::Zero();        // N, mean over the last tick: what the hand does to the body
  double impact = -1;               // s from the tick's start until they meet, 0: met before; < 0: they don't
};

/// server → participants with an arm, best effort, keyed by (participant, hand), each tick: what the hand
/// feels. Without planes it feels nothing; that is told, too, so that silence means a broken line.
struct FeltPlanes {
  ParticipantId participant = 0;
  std::uint8_t hand = right_hand;
  SimTime time;
  std::uint64_t input_sequence = 0;  // the last HandInput that the tick consumed
  std::vector<ContactPlane> planes;  // at most max_contact_planes
  double taken = 0;                  // J, since the hand appeared: what it gave to bodies …
  double given = 0;                  // … and what they gave to it; both only grow
};

/// participant → server, best effort, keyed by (participant, hand), with each HandInput: what the arm does.
struct ArmForce {
  ParticipantId participant = 0;
  std::uint8_t hand = right_hand;
  std::uint64_t sequence = 0;   // rises by one a sample
  Vec3 force = Vec3::Zero();    // N, on the hand, mean since the sample before
  double taken = 0, given = 0;  // J, as FeltPlanes': from and to the person's hand
};
inline constexpr double max_arm_force = 1000;  // N
inline constexpr double max_arm_energy = 1e9;  // J

/// server → all, reliable, transient-local, keyed by body: what people made of a body. Sent when it changes;
/// of a body that was never changed nothing is sent.
struct HandRef {
  ParticipantId participant = 0;
  std::uint8_t hand = right_hand;
  auto operator<=>(const HandRef&) const = default;
};
struct PartState {
  BodyId body = 0;
  SimTime time;
  bool attached = true;    // in its place in the anatomy
  bool hidden = false;     // neither seen nor touched
  bool lit = false;        // the light shaft falls on it
  bool inspected = false;  // seen as `shape` has it, and out of touch
  double opacity = 1;      // 0 … 1
  double stiffness = 1;    // times what the scene says
  Affine shape;
  std::vector<HandRef> holders;  // ascending
};
inline constexpr double least_stiffness = 0.25, most_stiffness = 4;
inline constexpr double most_shape = 100;  // largest entry of an inspected part's linear map

/// One control of a panel.
struct ControlState {
  double position = 0;   // button: 0 at rest … 1 pressed home; slider: 0 … 1
  bool on = false;       // button: what it switches is on
  bool touched = false;  // by a finger, or pointed at
};

/// server → all, reliable, transient-local, keyed by who called it up: the panel of one part, the same for
/// everyone.
struct Panel {
  ParticipantId participant = 0;
  SimTime time;
  bool open = false;
  BodyId body = 0;
  Pose pose;  // of its middle in the room: +z towards the reader, +y up
  std::array<ControlState, panel_control_count> controls{};
};

/// server → all, reliable, transient-local: what is everybody's.
struct RoomState {
  SimTime time;
  double lights = 1;  // brightness of all lights but the lamps that bodies carry, 0 … 1
  double pace = 1;    // simulated seconds a real one, as people have it; 0: time stands still
};

inline constexpr std::size_t step_phases = 8;

/// server → all, 10 Hz.
struct ServerStatus {
  SimTime time;
  double real_time_factor = 0;
  double step_ms_p50 = 0, step_ms_p99 = 0;  // over the last second
  std::array<double, step_phases>
      phase_ms{};              // mean over the last second, in step order (server/physics/base/step_report.h)
  double solver_residual = 0;  // worst relative residual of the last second
  double energy = 0;           // J: kinetic + elastic + gravitational
  std::uint32_t participants = 0, observers = 0;  // who takes part; who watches
  std::uint32_t awake_bodies = 0, asleep_bodies = 0;
  std::uint64_t invalid_dropped = 0;  // samples refused at the edge since start
  std::uint64_t state_hash = 0;       // of `time`
  std::string degraded;               // bodies reset, not converged or slowed, by name; empty is well
  double error = -1;                  // largest of the deformables', as they are now; < 0: none is known
};

/// What makes a body's error, as fractions. Where it is known which way, it has a sign: above 0 the body
/// gives way less than tissue would.
struct ErrorParts {
  double discretisation = 0;  // of mesh and elements
  double model = 0;           // of the law, against tissue's at the strains that occur
  double solver = 0;          // of the last tick's solve, ≥ 0
  double time = 0;            // of the last tick's length, ≥ 0
};

inline constexpr std::size_t max_error_map_side = 10;  // values
inline constexpr std::size_t max_error_map_values =
    max_error_map_side * max_error_map_side * max_error_map_side;

/// Where in a body its error is: values on a grid over its shape at rest, in between linear along each axis.
/// The mean over the body's volume is its error.
struct ErrorMap {
  Vec3 corner = Vec3::Zero();             // m, world frame: where the first value is
  double cell = 0;                        // m, from one value to the next
  std::array<std::uint8_t, 3> size{};     // values along x, y, z; all 0: not known
  std::vector<std::uint8_t> levels = {};  // x fastest; common/error_map.h tells what they mean
};

/// What modelling a body in some way gets wrong and costs, as tried on the body itself.
struct Price {
  double error = 0;  // of displacements or dents, fraction
  double ms = 0;     // CPU time a frame of 1/60 s
};
inline constexpr std::size_t max_prices = 8;

/// server → all, about 2 Hz while it is awake, keyed by body: how one deformable is stepped, and what of its
/// shape is not to be relied on. All errors are estimates of it as it is now. `residual` is measured, of the
/// solves of the last second (docs/understand/soft-tissue.md).
struct BodyStatus {
  BodyId body = 0;
  SimTime time;
  bool asleep = false;
  bool converged = true;         // in all ticks since the last one
  std::uint32_t substeps = 0;    // explicit and position-based bodies: in the last tick; 0: solved at once
  double step = 0;               // s: length of its time steps
  double newton_iterations = 0;  // mean over the ticks since the last one
  double solver_iterations = 0;  // of the linear solver: mean over the ticks since the last one
  double residual = 0;           // worst: force left unbalanced by a linear solve, over what it started from
  double correction = 0;         // m, worst: how far the last Newton step still moved a node
  double error = -1;             // of how far its loads move it, fraction; < 0: not known
  double expected_ms = -1;       // CPU ms a frame that were expected when it was chosen; < 0: not chosen
  std::uint32_t stepped_down = 0;  // by how many steps it is solved less exactly because of overload
  std::vector<Price> prices{};     // what it can have, the cheapest first; empty: nobody asked
  ErrorParts parts = {};           // of `error`
  double press_error = -1;         // of the force that is felt where it is pressed, fraction; < 0: not known
  ErrorMap error_map = {};
};
inline constexpr std::uint32_t max_steps_down = 3;

/// What happened in a recorded session, as marks tell.
enum class MarkKind : std::uint8_t { joined, left, cut, taken_back, reset };
inline constexpr MarkKind last_mark = MarkKind::reset;

/// Something that happened in a recorded session.
struct RecordingMark {
  std::uint64_t tick = 0;
  MarkKind kind = MarkKind::cut;
  std::string who;  // name of who did it; empty: nobody
};
inline constexpr std::size_t max_recording_marks = 1024;

/// server → all, reliable, transient-local: that a recording is watched. Its ticks are those of SimTime.
struct Recording {
  std::uint64_t last_tick = 0;       // it begins at 0
  std::vector<RecordingMark> marks;  // by tick, ascending
};

/// Everything that a Bus carries. A message's place is its topic's index (idl/topics.h).
using Message =
    std::variant<SessionInfo, Presence, RosterEntry, HandInput, UserState, Command, CommandResult, SceneInfo,
                 AssetChunk, RigidState, SoftState, Settled, TopologyRevision, ContactSample, ServerStatus,
                 BodyStatus, PartState, Panel, RoomState, Recording, FeltPlanes, ArmForce>;

}  // namespace prosector
