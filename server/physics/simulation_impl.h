#pragma once
// The running state and the phases of a step. Private to the simulation's .cpp files.

#include <tbb/task_arena.h>

#include <map>
#include <utility>

#include "server/physics/byte_stream.h"
#include "server/physics/collision/broad_phase.h"
#include "server/physics/collision/rigid_outline.h"
#include "server/physics/contact/layers.h"
#include "server/physics/contact/memory.h"
#include "server/physics/contact/parting.h"
#include "server/physics/contact/rough_shape.h"
#include "server/physics/contact/self_surface.h"
#include "server/physics/contact/shape_touch.h"
#include "server/physics/contact/soft_meeting.h"
#include "server/physics/contact/surface_detector.h"
#include "server/physics/coupled/recovery.h"
#include "server/physics/coupled/step_island.h"
#include "server/physics/fracture.h"
#include "server/physics/hands/finger_drive.h"
#include "server/physics/hands/hand.h"
#include "server/physics/model.h"
#include "server/physics/organs/blade.h"
#include "server/physics/organs/locate.h"
#include "server/physics/organs/organ.h"
#include "server/physics/panel/panel_world.h"

namespace prosector {

inline constexpr double contact_margin = 0.002;  // m: gaps up to it may close within the tick
inline constexpr double wake_margin = 0.003;     // m
inline constexpr double most_reach = 0.05;       // m a tick: faster things are met late
// Contacts between rigid bodies: times the mass of the island's heaviest body over h². It may rest on a light
// one, no deeper than 0.2 mm.
inline constexpr double rigid_contact_factor = 20;
inline constexpr double still_margin = 0.005;  // m a soft body moves before its place in a tree may change

/// Tissue that holds back a point of a blade's edge.
struct BladeGrip {
  std::size_t body = 0;   // soft
  std::size_t slot = 0;   // of the instrument
  std::size_t point = 0;  // of Blade::cut_to
  SparseMap::Row row;     // of the material where the point has cut to
  /// Of a sheet that the edge goes through between this point and the next: at this share of the way.
  std::optional<double> through{};
  Vec3 beside = Vec3::Zero();  // m: from that material to the point, of one that has come down on a sheet
  Tie tie;
};

/// Surface vertices of a soft body that hang on tissue that is inside out: they tell nothing of where it is.
struct InsideOut {
  bool known = false;          // in this tick
  std::vector<char> vertices;  // 1: so; empty: none
};

using Entanglements = std::map<std::pair<std::size_t, std::size_t>, Entanglement>;

/// Two soft bodies that touch.
struct SoftPair {
  std::size_t a = 0, b = 0;  // a < b
  std::vector<Contact> contacts;
};

/// A finger's pad on a rigid body: a contact, and behind it those of its friction.
struct Pad {
  std::size_t island = 0, contact = 0;  // indices
  std::size_t hand = 0, body = 0;       // slots
  std::uint32_t part = 0;               // of the hand
  Vec3 place = Vec3::Zero();            // m, in its centre's frame
};

struct Simulation::Impl : PanelSubjects {
  /// What a soft body has where it is.
  struct StoredEnergy {
    double elastic = 0, weight = 0;  // J
  };

  Impl(const SceneDesc& scene, const CompileOptions& options);

  // ---- Model
  Model model;
  std::vector<VecX> equilibrium;        // per soft body: node positions at rest under gravity
  std::vector<VecX> uncut_equilibrium;  // likewise, of the scene's bodies as they were compiled
  /// What a first cut asks of its organ's mesh, until one is made, by soft body: of scenes with a blade.
  std::map<std::size_t, Organ> uncut_organs;

  // ---- State
  SimTime time;
  RigidWorld world;
  std::vector<SoftBodyState> soft;
  std::vector<ContactMemories> memories;  // per soft body
  std::vector<Hand> hands;                // by (participant, side)
  std::vector<Part> parts;                // by body
  std::map<std::size_t, Organ> organs;    // those that were cut, by the soft body that each was
  std::vector<Blade> blades;              // that hands hold, by slot
  std::uint64_t strokes = 0;              // of all blades so far
  std::vector<std::uint32_t> revisions;   // per soft body
  std::vector<Numbering> numberings;      // likewise

  std::map<BodyId, std::uint8_t> lost;  // how often they left the room since somebody last held them

  std::optional<PanelWorld> panels;  // of scenes with parts
  double room_lights = 1;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<LayerSide>> layer_sides;  // by soft bodies

  // ---- Of the current tick
  std::vector<SurfaceDetector> surfaces;
  std::vector<std::optional<RoughShape>> rough;  // per soft body: of those that collide as simple shapes
  std::vector<std::optional<RigidOutline>>
      outlines;  // for these: per rigid body, of each hand, of the room's sides
  std::vector<std::optional<TriangleSurface>> faces;  // per soft body: see faces_of
  std::vector<char> faces_moved;                      // per soft body: they are where its surface is
  std::vector<std::vector<Contact>> soft_contacts;    // per soft body: with rigid ones
  BroadPhase soft_boxes;                              // of soft bodies that collide, by index
  std::vector<std::optional<SelfSurface>> folds;      // per soft body: of solids that meet themselves
  std::vector<char> layered;                          // per soft body: thin, and may meet others as layers
  std::vector<std::optional<ElementSurface>> layers;  // of those: made when asked for, at rest
  std::vector<char> layers_moved;                     // per soft body, as faces_moved
  std::vector<int> passed_through;                    // per soft body: elements that a layer has passed
  std::vector<SoftPair> soft_pairs;                   // ascending, those with contacts
  std::vector<InsideOut> inside_out;                  // per soft body: see inside_out_of
  Entanglements entangled;                            // by soft bodies, the lower first
  Entanglements still_entangled;                      // as found in this tick
  std::vector<std::optional<std::size_t>> parted;     // per soft body: another that it is led out of
  std::vector<VertexMeeting> meetings;                // what finding them works in
  std::vector<std::size_t> soft_group;  // per soft body: the first that it hangs together with, by soft pairs
  std::vector<Collider> colliders;      // by slot, then of the room's sides
  std::vector<RigidMotion> last_good;   // by slot, at the tick's start
  std::vector<Island> islands;
  std::vector<Pad> pads;                    // in the islands' order
  double step_h;                            // s: the tick, or its part that is under way (advance_in_parts)
  std::vector<Exchange> earlier_exchanges;  // of the tick's parts before that
  IslandStepper stepper;
  std::vector<BladeShape> blade_shapes;  // per rigid body
  std::vector<BladeGrip> blade_grips;
  std::map<std::size_t, std::vector<Vec3>> organ_positions;  // of those that this tick cut: by node id
  CutResult cut_figures;                                     // of this tick, over all
  std::vector<std::unique_ptr<SoftBody>> retired;            // the tick's islands still know them
  std::vector<HandState> hand_states;
  std::vector<std::optional<StoredEnergy>> stored;  // per soft body: of those asleep it stays what it was
  StepReport report;
  tbb::task_arena arena;

  // ---- Phases (in step order)
  void take_inputs(const TickInput& input);
  void drive(const Drive& drive);  // part of it
  class PhaseClock;
  void advance_in_parts(PhaseClock& clock);
  int parts_of_tick();              // part of it
  void advance(PhaseClock& clock);  // likewise
  void detect_soft_contacts();      // part of that
  void detect_soft_pairs();         // part of it
  void group_soft_bodies();         // part of that
  const std::vector<MixedIsland>& find_islands();
  void gather(const std::vector<MixedIsland>& mixed);
  /// Part of it: the friction of an island's last contact becomes that of a patch, if it is a finger's.
  void spread_over_pad(const RigidContact& touch, std::size_t island);
  void place_pads(std::vector<RigidContact>& touches, std::size_t slot) const;  // before that, if it's a hand
  void watch_flat_elements(Island& island);                                     // part of it
  void solve_islands();
  void keep_pads();  // part of it
  void bounce_rigid();
  void recover_hands();
  void bring_back_lost();
  void bring_back(BodyId body);  // part of it
  Aabb within_reach() const;     // likewise: what is beyond is lost
  void unfold_tangles();
  Surroundings surroundings_of(std::size_t body);  // part of it
  bool in_a_hand(std::size_t body) const;
  bool is_being_led(std::size_t body) const;
  bool is_squeezed(std::size_t body) const;
  bool is_blind(std::size_t body);
  void place_unfolded(std::size_t body, double lowest);
  void make_room_for(std::size_t body);
  bool part_at_once(std::size_t a, std::size_t b);
  void disentangle(std::size_t a, std::size_t b);
  void put_beside(std::size_t body, std::size_t other);
  void tell_reset(std::size_t body, const std::string& why);
  void fall_asleep();
  void describe();
  StoredEnergy stored_in(std::size_t body) const;  // part of it
  void describe_hands();                           // likewise
  void note(ContactSample& sample, const Contact& contact, bool hand_is_b, double& strongest) const;
  std::vector<Exchange> exchanges() const;

  // ---- Hands
  void appear(ParticipantId participant, std::size_t side);
  void vanish(std::vector<Hand>::iterator hand);
  void grasp(Hand& hand);
  void release(Hand& hand, const std::string& why);
  void let_go_of(BodyId body, const char* why);
  std::optional<Hold> reach_rigid(const Hand& hand) const;
  std::optional<Hold> reach_soft(const Hand& hand);
  std::vector<Touch> touches_of_rigid(const Hand& hand, BodyId body) const;
  std::vector<Touch> touches_of_soft(const Hand& hand, std::size_t body) const;
  void tend_holds();
  bool was_set_down(Hand& hand, const Vec3& force);
  Vec3 place_of(const Hold& hold, const Hold::Point& point) const;
  Vec3 hold_force(const Hand& hand) const;
  void add_hold(ContactSample& sample, const Hand& hand) const;
  Vec3 support(BodyId body) const;
  std::vector<Hand>::iterator find_hand(ParticipantId participant, std::size_t side);
  const Hand* hand_at(std::size_t slot) const;

  // ---- Fingers
  struct FingerPoses;
  using FingerObstacles = std::array<std::vector<Obstacle>, fingers>;
  void bend_fingers();
  void bend(Hand& hand);
  void add_rigid_obstacles(const Hand& hand, const FingerPoses& poses, FingerObstacles& out) const;
  void add_soft_obstacles(const Hand& hand, const FingerPoses& poses, FingerObstacles& out) const;

  // ---- Parts
  bool is_part(BodyId body) const;
  const std::string& name_of(BodyId body) const;
  std::string obey(const PartEvent& event);
  double distance_from_place(BodyId body) const;
  void make(BodyId body, const Part& wanted);
  void take_effect(RigidWorld& rigid_world, BodyId body);
  void freeze(std::size_t body);
  void wake_everything();
  Part initial_part(BodyId body) const;
  std::vector<Part> initial_parts(std::size_t soft_bodies) const;

  // ---- Fracture
  struct PointForce {
    Vec3 point, force;  // m, N
  };
  std::vector<PointForce> forces_on(std::size_t slot) const;
  double force_through_free(BodyId body, const RigidModel::Fracture& plane, const PlaneLoad& load) const;
  double force_through_held(BodyId body, const RigidModel::Fracture& plane, const PlaneLoad& load) const;
  void break_bones();
  void break_at(BodyId body, const RigidModel::Fracture& plane, double force);
  void hand_over(Hand& hand, const RigidModel::Fracture& plane);

  // ---- Cuts
  bool is_held_blade(std::size_t slot) const;
  std::vector<Vec3> edge_points(std::size_t slot) const;  // m, room frame
  struct TissueNear {
    std::size_t body = 0;
    Locator locator;
  };
  std::vector<TissueNear> tissue_near(const Aabb& box) const;
  static std::optional<BladeGrip> tissue_at(std::span<const TissueNear> tissue, const Vec3& point);
  static Aabb swept_box(std::span<const Vec3> from, std::span<const Vec3> to);
  void take_up_blades();
  void grip_blades();
  void cut_soft_bodies(const TickInput& input);
  void advance(Blade& blade);
  bool stop_at_the_surface(std::span<const Vec3> from, std::span<Vec3> to) const;
  bool enter_volumes(const Blade& blade, std::span<const Vec3> from, std::span<Vec3> to) const;
  struct SheetCrossing;
  struct NearSheet;
  bool can_cut_sheet(std::size_t body) const;
  static std::vector<SheetCrossing> sheet_crossings(const NearSheet& sheet, std::span<const Vec3> edge);
  void grip_sheets(const Blade& blade, std::span<const Vec3> now);
  void drag_edges(const Blade& blade, std::span<const Vec3> now, std::span<Vec3> from,
                  std::span<Vec3> to) const;
  bool stop_at_sheets(const Blade& blade, std::span<const Vec3> from, std::span<Vec3> to) const;
  std::vector<std::uint8_t> held_nodes_of(std::size_t body) const;
  void cut_tissue(Blade& blade, std::size_t edge, std::span<const Vec3> from, std::span<const Vec3> to);
  bool can_cut(std::size_t body, bool with_ray) const;
  void make_organs_ready();
  Organ& organ_of(std::size_t body);
  void cut_organ(Blade& blade, std::size_t edge, std::size_t first, std::span<const Vec3> from,
                 std::span<const Vec3> to);
  void carry_beside_sheet(BladeStroke& stroke, const Blade& blade, std::size_t edge,
                          std::span<const Vec3> from) const;
  std::vector<Vec3> node_positions(const Organ& organ) const;
  void obey(const CutEvent& event);
  std::unique_ptr<SoftBody> same_tissue(std::size_t body, SoftDesc desc, Anatomy anatomy) const;
  std::unique_ptr<SoftBody> make_piece(const Organ& organ, std::size_t body, Numbering& numbering) const;
  void place_piece(std::size_t body, std::size_t first, std::unique_ptr<SoftBody> solver, Numbering numbering,
                   SurfaceDetector surface);
  /// What a piece's solver and its surface, which are there, follow.
  struct Following {
    PieceEdit edit;
    std::optional<SurfaceEdit> surface;  // none: it becomes another altogether, which is
    PieceSurface skin;
    std::optional<Anatomy> sheet;  // a sheet's geometry, which is made whole
    Numbering numbering;
  };
  bool can_follow(const Organ& organ, const PieceEdit& edit) const;
  Following following(const Organ& organ, PieceEdit edit, std::optional<SurfaceEdit> surface) const;
  std::optional<Following> following_since(const Organ& organ, const Organ::Regrouped& then,
                                           const OrganPiece& piece) const;
  void take_solver_along(Following& following);
  void take_surface_along(const Following& following);
  struct NewPiece;
  using BroughtBack = std::map<std::size_t, Motion>;  // by body
  BroughtBack brought_back(const Organ& organ, const Organ::Regrouped& changed) const;
  const Motion& motion_before(std::size_t body, const BroughtBack& back) const;
  void leave_what_went_back(const BroughtBack& back);
  std::vector<NewPiece> make_pieces(const Organ& organ, const Organ::Regrouped& changed,
                                    const BroughtBack& back) const;
  void make_anew(const Organ& organ, NewPiece& made) const;  // part of it
  void carry_motion(const Organ& organ, std::span<const OrganPiece> before, const BroughtBack& back,
                    const OrganPiece& piece, NewPiece& made) const;  // likewise
  void follow_changes(std::span<NewPiece> pieces);
  void keep_momentum_of(const Organ& organ, const Organ::Regrouped& changed, BroughtBack& back,
                        std::span<const VecX> masses, std::span<NewPiece> made);
  void place(NewPiece piece, std::size_t first, TopologyCause cause, ParticipantId author);
  void set_going(std::size_t body, std::size_t first, Motion motion, VecX balance);
  TopologyChange& tell_of(std::size_t body, std::uint64_t content_hash, TopologyCause cause,
                          ParticipantId author);
  bool follow_cut(Organ& organ, TopologyCause cause, ParticipantId author);
  void remake(Organ& organ, TopologyCause cause, ParticipantId author);
  std::string carry_through(std::size_t first, const Organ::Mark& before, TopologyCause cause,
                            ParticipantId author);
  void keep_holds(const std::vector<std::size_t>& bodies);
  std::string rewind(const CutEvent& event);
  void go_back(const CutEvent& event);                                                         // part of it
  void bring_back_hands(std::span<const Hand> present, std::span<const RigidMotion> motions);  // likewise
  std::size_t add_hand(RigidWorld& rigid_world, const Hand& hand, const RigidMotion& motion) const;
  std::uint64_t log_length() const;
  void report_cuts();

  // ---- Panels
  bool has_panel(BodyId body) const override;
  std::pair<Vec3, Vec3> box(BodyId body) const override;
  ShownControls shown(BodyId body) const override;
  std::vector<PanelHand> panel_hands() const;
  void step_panels();
  void carry_out(const PanelAction& action);

  // ---- Bodies
  bool is_soft(BodyId body) const { return body >= model.rigid.size(); }
  std::size_t soft_index(BodyId body) const { return body - model.rigid.size(); }
  BodyId soft_id(std::size_t index) const { return static_cast<BodyId>(model.rigid.size() + index); }
  void reset_body(BodyId body);
  void put_at_start(BodyId body);  // at rest
  void refresh_colliders();
  Collider room_collider(std::size_t side) const;
  static Vec3 driven_way(const Collider& collider, const Vec3& point);  // m: where the tick takes its point
  Contact soft_contact(std::size_t body, const Vec3& point, const Distance& distance,
                       const Collider& collider) const;  // what its kinds have in common
  Contact vertex_contact(std::size_t body, std::uint32_t vertex, const Distance& distance,
                         const Collider& collider) const;
  Contact face_contact(std::size_t body, const TriangleTouch& touch, const Collider& collider) const;
  /// Whether the soft body and the rigid one touch at all.
  bool may_meet(std::size_t body, const Collider& collider) const;
  bool may_meet(std::size_t a, std::size_t b) const;  // two soft ones
  bool woken_by_soft(std::size_t body);
  static SurfaceDetector detector(const SoftBody& body);
  /// Puts everything that hangs on the body's mesh in place of what there was; the body may be new.
  void fit_to_mesh(std::size_t body, SurfaceDetector surface, Numbering numbering);
  /// What of that is made anew where surfaces and faces followed.
  void fit_rest_to_mesh(std::size_t body, Numbering numbering);
  const TriangleSurface* faces_of(std::size_t body);  // null: a rope's
  void track_soft_bodies();                           // to where they are, and may be within the tick
  Aabb box_of(std::size_t body) const;                // of a soft one, likewise
  SoftSkin skin(std::size_t body);
  double reach_of(std::size_t body) const;        // m: how far its nodes move within the tick
  double inner_reach_of(std::size_t body) const;  // m: likewise, less what they have in common
  /// Without points: the sides are yet to be filled in.
  Contact pair_contact(std::size_t a, std::size_t b, const Vec3& normal, double gap) const;
  Contact pair_contact(std::size_t a, std::size_t b, const VertexMeeting& meeting) const;
  double pair_stiffness(std::size_t a, std::size_t b, std::uint32_t vertex_of_a) const;
  /// Appends where the two come within `margin` of each other; whether there was any.
  bool add_pair_contacts(std::size_t a, std::size_t b, double margin, std::vector<Contact>& out);
  /// Whether the two sides, `gap` m apart now, may come together within the tick.
  bool nears(const Contact& contact, double gap) const;
  bool add_self_contacts(std::size_t body, double margin, std::vector<Contact>& out);
  const std::vector<char>& inside_out_of(std::size_t body);
  /// Puts what leads the two bodies apart in place of contacts (from `before` on in `out`) that can't tell
  /// the way out.
  void part(std::size_t a, std::size_t b, std::size_t before, std::vector<Contact>& out);
  Vec3 middle_of(std::size_t body) const;  // m: its centre of mass
  // Of layers:
  void fit_layers(std::size_t body);
  bool has_layers() const;               // a body that may meet so, and sides to remember
  bool is_thin(std::size_t body) const;  // a sheet or a rope
  const ElementSurface& layers_of(std::size_t body);
  bool add_layer_contacts(std::size_t a, std::size_t b, double margin, std::vector<Contact>& out);
  void forget_layers(const std::vector<BroadPhase::Pair>& near);
  // Of simple shapes:
  void fit_rough_shape(std::size_t body);
  double rough_stiffness(std::size_t body) const;
  const std::optional<RigidOutline>& outline_at(std::size_t slot) const;
  bool add_rough_contacts(std::size_t body, const Collider& collider, double margin,
                          std::vector<Contact>& out) const;
  bool add_rough_pair_contacts(std::size_t a, std::size_t b, double margin, std::vector<Contact>& out) const;
  /// Takes what others touch of the body to where its nodes are.
  void follow_nodes(std::size_t body);  // within a tick: its surface goes where its nodes have been put
  void place_surface(std::size_t body);
  Aabb outer_box(std::size_t body) const;  // around what others touch of it
  /// Whether any of that is within `margin` of the collider.
  bool touches(std::size_t body, const Collider& collider, double margin) const;
  double skin_of(std::size_t body) const;  // m: from the surface that is simulated to the one that is touched
  ContactSide surface_side(std::size_t body, std::uint32_t vertex) const;
  /// Appends what of the body's surface is within `margin` of the collider, with what it remembers; whether
  /// there was any.
  bool add_contacts(std::size_t body, const Collider& collider, double margin, const ContactMemories& held,
                    std::vector<Contact>& out) const;
  /// Whether the two are met at their time of impact rather than where they are near each other now.
  bool is_swept(std::size_t body, const Collider& collider) const;
  /// As add_contacts, but where nothing touches yet: what will, when the collider first comes near.
  /// Velocities are taken as constant, the soft body's as that of its middle.
  bool add_swept_contacts(std::size_t body, const Collider& collider, double margin,
                          std::vector<Contact>& out) const;
  void wake_soft(std::size_t body);
  void settle(const CompileOptions& options);
  void settle_crushed(std::span<const std::size_t> bodies);
  void tell_if_crushed(std::size_t body, const CompileOptions& options);  // part of it
  std::vector<std::vector<std::size_t>> neighbourhoods();
  void relax(std::span<const std::size_t> bodies);
  bool floats(std::span<const std::size_t> bodies) const;
  double total_speed(const Collider& collider) const;
  double body_mass(std::size_t slot) const;
  double body_friction(std::size_t slot) const;

  // ---- Saving
  bool ever_cut() const { return !organs.empty() || !blades.empty() || strokes > 0; }
  void save_cuts(ByteWriter& out) const;
  void forget_bodies_from(std::size_t count);  // soft ones
  void save(ByteWriter& out) const;
  void load(std::span<const std::uint8_t> bytes);
};

}  // namespace prosector
