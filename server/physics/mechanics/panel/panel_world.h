#pragma once
// All panels in the room: owner and part of each, the state of its controls, and the requested actions.
// Separate from the world of bodies (docs/decisions/0008): fingers move the controls, but controls never move
// fingers.
//
// All of it is state: saved, restored, hashed. Timeouts are counted in ticks.

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "common/part_messages.h"
#include "server/physics/mechanics/panel/panel_event.h"
#include "server/physics/mechanics/panel/panel_motion.h"
#include "server/physics/mechanics/panel/panel_place.h"

namespace prosector {
class RecordReader;
class RecordWriter;
}  // namespace prosector

namespace prosector::panel {

/// Hand of a participant, or a stylus, as input for the panels: palm, finger segments, fist, and the touched
/// body.
struct PanelHand {
  HandRef who;
  Vec3 palm = Vec3::Zero();        // m, world frame: centre of the palm
  std::vector<Capsule> fingers;    // world frame, in fixed order
  Capsule index;                   // last segment of the index finger, beginning at its tip; radius 0: none
  bool fist = false;               // whether four fingers are bent and hold nothing
  double bend = 0;                 // smallest flexion of the four fingers, 0 … 1
  std::optional<BodyId> touches;   // the body that it touches most
  Vec3 touched_at = Vec3::Zero();  // m, world frame
};

/// Values that a panel's controls show while nobody operates them, indexed by control: for a button 0 (off)
/// or 1 (on), for the slider 0 … 1.
using ShownControls = std::array<double, panel_control_count>;

/// Interface through which the panels query bodies: which have a panel, where they are, and which values
/// their controls show.
class PanelSubjects {
 public:
  virtual ~PanelSubjects() = default;
  /// Returns whether the body has a panel: it must be a part (a body that users can detach, attach and
  /// inspect) that can be touched.
  virtual bool has_panel(BodyId body) const = 0;
  virtual std::pair<Vec3, Vec3> box(BodyId body) const = 0;  // world frame, lowest and highest corner
  virtual ShownControls shown(BodyId body) const = 0;
  /// Returns the first body that has a panel; empty if none has.
  virtual std::optional<BodyId> first() const = 0;
};

/// Request that a participant makes by operating a control of a panel: set this control of body `body` to
/// `value`.
struct PanelAction {
  ParticipantId participant = 0;
  BodyId body = 0;
  PanelControl control = PanelControl::attach;
  double value = 0;
};

/// State and simulation of all open panels: control boards that float in the room, at most one per
/// participant, and operated with fingers.
class PanelWorld {
 public:
  /// Creates a world without panels. `h`: length of a tick, s.
  explicit PanelWorld(double h);

  void take(const HeadPlace& head);
  void take(const HeldPlace& held);
  void take(const PanelEvent& event, const PanelSubjects& subjects);
  /// Advances all panels by one tick: tablets and fists carry panels, fingers move controls, touched parts
  /// open panels, and timeouts close them. Returns the requests made by operating controls. `hands`: all
  /// tracked hands.
  std::vector<PanelAction> step(std::span<const PanelHand> hands, const PanelSubjects& subjects);
  /// Updates the values that the controls show from the bodies, after the actions returned by step() were
  /// carried out. An untouched slider moves to its shown value.
  void show(const PanelSubjects& subjects);

  /// Returns the hands whose fist currently carries a panel, ascending.
  std::vector<HandRef> carriers() const;
  /// Returns the open panels as messages for clients, ordered by participant. The messages' `time` is not
  /// set; the caller must set it.
  std::vector<Panel> panels() const;

  void save(RecordWriter& io) const;
  /// Restores the panels from a checkpoint. Throws InputError for an impossible state. `body_count`: number
  /// of bodies in the simulation, which limits body indices.
  void load(RecordReader& io, std::size_t body_count);

 private:
  /// Tracked tablet of a participant, to whose pose the participant's panel is attached.
  struct Tablet {
    Pose pose;                 // of the panel, world frame
    bool seen = true;          // whether it is tracked
    bool answered = false;     // whether its request for a panel was handled
    std::uint32_t unseen = 0;  // ticks
  };
  /// Fist that carries a panel, with the palm's position relative to the panel.
  struct Hold {
    HandRef who;
    Vec3 at = Vec3::Zero();  // m: position of the palm in the panel's frame
  };
  struct Open {
    BodyId body = 0;
    Pose pose, came_up;        // current and initial pose
    std::optional<Hold> hold;  // none: not carried
    std::uint32_t pinned = 0;  // remaining ticks in which the panel stays open, whatever is touched
    ControlMotions motions;
    std::array<bool, panel_control_count> home{};     // pressed to the stop, and not yet released
    std::array<bool, panel_control_count> touched{};  // by a finger this tick
    // Remaining ticks in which a control set by an event is shown as touched.
    std::array<std::uint32_t, panel_control_count> pointed{};
    ShownControls shown{};
    std::uint32_t idle = 0;  // number of ticks without touch
    /// For each hand, the set of finger segments (as bits) that moved under the panel's front from outside
    /// its outline. These segments press no controls until they have been above its front. Hands without such
    /// segments have no entry.
    std::map<HandRef, std::uint64_t> came_under;
  };
  /// Touch of a body by a hand: the body, the ticks that the touch has lasted, and whether it has already
  /// opened the body's panel or closed another one.
  struct Rest {
    BodyId body = 0;
    std::uint32_t ticks = 0;
    bool answered = false;  // whether its request was handled
  };

  /// State of a hand near open panels: whether it is a fist, and when and where it last closed at a panel's
  /// head (upper strip).
  struct Fist {
    bool closed = false;
    std::uint32_t since = no_fist;  // ticks since it closed at a panel's head
    Vec3 at = Vec3::Zero();         // m, world frame: position of the palm at that time
  };
  static constexpr std::uint32_t no_fist = 1u << 30;  // ticks: it never closed there

  double h_;
  std::map<ParticipantId, Open> open_;
  std::map<ParticipantId, PanelReader> heads_;
  std::map<HandRef, Rest> rests_;
  std::map<HandRef, std::vector<Capsule>> last_fingers_;
  std::map<HandRef, Fist> fists_;
  std::map<ParticipantId, Tablet> tablets_;  // until they are released
  std::map<ParticipantId, Capsule> styli_;   // world frame, starting at the tip
  std::vector<PanelAction> asked_;           // requested by events, for the next step

  void open(ParticipantId who, BodyId body, const Vec3& touched, const Vec3* palm, double side,
            const PanelSubjects& subjects);
  void set(Open& panel, const PanelEvent& event);
  std::vector<PanelHand> with_styli(std::span<const PanelHand> hands) const;
  void lay_on_tablets(const PanelSubjects& subjects);
  void carry(std::span<const PanelHand> hands);
  void take_hold(const PanelHand& hand, Fist& fist);
  void follow(ParticipantId who, Open& panel, std::span<const PanelHand> hands);
  void place(ParticipantId who, Open& panel, const Vec3& middle);
  void move(ParticipantId who, Open& panel, const Pose& before, std::span<const PanelHand> hands);
  static bool reaches_head(const Open& panel, const PanelHand& hand);
  static bool presses(const Open& panel, const PanelHand& hand);
  static std::uint64_t came_under(const Open& panel, const PanelHand& hand, std::uint64_t under);
  std::vector<FingerSweep> fingers_before(Open& panel, const Pose& before,
                                          std::span<const PanelHand> hands) const;
  void feel(const PanelHand& hand, const PanelSubjects& subjects);
  void grow_old(std::span<const PanelHand> hands, const PanelSubjects& subjects);
  void remember(std::span<const PanelHand> hands);
  std::uint32_t ticks(double seconds) const;
  template <class Io>
  static void entry_of(Io& io, typename Io::template Entry<Open>& panel, std::size_t body_count);
  template <class Io>
  static void entry_of(Io& io, typename Io::template Entry<PanelWorld>& world, std::size_t body_count);
};

inline constexpr std::uint8_t stylus_hand = 2;   // HandRef::hand of a stylus
inline constexpr std::size_t most_fingers = 64;  // largest number of segments of a hand
inline constexpr double stylus_radius = 0.003;   // m
inline constexpr double stylus_length = 0.1;     // m: length of the shaft that acts on panels
inline constexpr double tablet_rest = 3;  // s: time for which a panel stays at the last pose of a lost tablet
inline constexpr double touch_moment = 0.25;  // s: time for which a hand must touch a part to open its panel
inline constexpr double panel_timeout = 10;   // s without touch until a panel closes
// s: time for which a panel stays open after a finger pointed at it.
inline constexpr double pinned_by_hand = 0.5;
inline constexpr double pinned_from_afar = 1.5;  // s: the same after its owner opened it again by an event
inline constexpr double pointing_reach = 0.5;    // m: pointing distance of a fingertip
// s: a second fist at the head within this time resets the panel's pose.
inline constexpr double second_fist = 1;
inline constexpr double second_fist_way = 0.03;  // m: largest motion of the palm between the two fists
// Flexion of all four fingers: a hand beyond it is closing and presses nothing.
inline constexpr double closing_bend = 0.5;
inline constexpr double closing_at_head = 0.2;  // the same limit while the hand reaches a panel's head
// s: time for which a control set by an event is shown as touched.
inline constexpr double pointed_time = 0.3;
inline constexpr double home_position = 0.85;   // of the travel: a button beyond it counts as pressed
inline constexpr double let_go_position = 0.4;  // of the travel: a pressed button below it counts as released

}  // namespace prosector::panel
