#pragma once
// The panels in the room: who has called up which part's, how its controls stand, and what that asks for.
// A world of its own beside the bodies' (docs/decisions/0008): fingers move the controls, never the other
// way.
//
// All of it is state: saved, restored, hashed. Timeouts count ticks.

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "common/byte_stream.h"
#include "server/physics/panel/panel_event.h"
#include "server/physics/panel/panel_motion.h"
#include "server/physics/panel/panel_place.h"

namespace prosector {

/// A hand as panels feel it.
struct PanelHand {
  HandRef who;
  Vec3 palm = Vec3::Zero();        // m, world frame, its middle
  std::vector<Capsule> fingers;    // world frame, always in the same order
  Capsule index;                   // the last segment of the index finger, from its tip on; no radius: none
  bool fist = false;               // its four fingers are bent, around nothing that it holds
  double bend = 0;                 // flexion that all four fingers have at least, 0 … 1
  std::optional<BodyId> touches;   // the body it touches most
  Vec3 touched_at = Vec3::Zero();  // m, world frame
};

/// How a control stands if nobody works it: buttons 0 off, 1 on; the slider 0 … 1.
using ShownControls = std::array<double, panel_control_count>;

/// What panels ask about bodies.
class PanelSubjects {
 public:
  virtual ~PanelSubjects() = default;
  /// Tells whether the body is a part that can be touched: others have no panel.
  virtual bool has_panel(BodyId body) const = 0;
  virtual std::pair<Vec3, Vec3> box(BodyId body) const = 0;  // world frame, lowest and highest corner
  virtual ShownControls shown(BodyId body) const = 0;
  /// Returns the first part that has a panel; nullopt: none has.
  virtual std::optional<BodyId> first() const = 0;
};

/// What somebody asked by working a control.
struct PanelAction {
  ParticipantId participant = 0;
  BodyId body = 0;
  PanelControl control = PanelControl::attach;
  double value = 0;
};

class PanelWorld {
 public:
  /// Takes the length h of a tick, s.
  explicit PanelWorld(double h);

  void take(const HeadPlace& head);
  void take(const HeldPlace& held);
  void take(const PanelEvent& event, const PanelSubjects& subjects);
  /// Advances by one tick: tablets and fists carry panels, fingers move controls, touches open panels, time
  /// closes them. Returns what was asked for.
  std::vector<PanelAction> step(std::span<const PanelHand> hands, const PanelSubjects& subjects);
  /// Makes controls show how things stand, after the actions were carried out.
  void show(const PanelSubjects& subjects);

  /// Returns the hands that carry a panel, ascending.
  std::vector<HandRef> carriers() const;
  /// Returns the open panels, by participant; `time` is the caller's to fill.
  std::vector<Panel> panels() const;

  void save(ByteWriter& out) const;
  /// Throws InputError for what no panel world can be in. `body_count`: of the simulation.
  void load(ByteReader& in, std::size_t body_count);

 private:
  /// A board in somebody's hand, which their panel lies on.
  struct Tablet {
    Pose pose;                 // of the panel, world frame
    bool seen = true;          // by what tracks it
    bool answered = false;     // it has called up a panel where none was open
    std::uint32_t unseen = 0;  // ticks
  };
  /// A panel's place in the fist that carries it.
  struct Hold {
    HandRef who;
    Vec3 at = Vec3::Zero();  // m, of the palm in the panel's frame
  };
  struct Open {
    BodyId body = 0;
    Pose pose, came_up;        // now, and at first
    std::optional<Hold> hold;  // nullopt: nobody carries it
    std::uint32_t pinned = 0;  // ticks that it stays, whatever is touched
    ControlMotions motions;
    std::array<bool, panel_control_count> home{};              // pressed home, and not yet let go
    std::array<bool, panel_control_count> touched{};           // by a finger this tick
    std::array<std::uint32_t, panel_control_count> pointed{};  // ticks that a set control is still shown so
    ShownControls shown{};
    std::uint32_t idle = 0;  // ticks without touch
    /// Bits, not all 0: segments of hands that came under its front from beside it, and press nothing.
    std::map<HandRef, std::uint64_t> came_under;
  };
  /// A hand on a body, for how long.
  struct Rest {
    BodyId body = 0;
    std::uint32_t ticks = 0;
    bool answered = false;  // what it asked for was done
  };

  /// A hand beside open panels.
  struct Fist {
    bool closed = false;
    std::uint32_t since = no_fist;  // ticks since it closed at a panel's head
    Vec3 at = Vec3::Zero();         // m, world frame: its palm then
  };
  static constexpr std::uint32_t no_fist = 1u << 30;  // ticks: it never did

  double h_;
  std::map<ParticipantId, Open> open_;
  std::map<ParticipantId, PanelReader> heads_;
  std::map<HandRef, Rest> rests_;
  std::map<HandRef, std::vector<Capsule>> last_fingers_;
  std::map<HandRef, Fist> fists_;
  std::map<ParticipantId, Tablet> tablets_;  // until they are let go
  std::map<ParticipantId, Capsule> styli_;   // world frame, the tip first
  std::vector<PanelAction> asked_;           // by events, for the next step

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
  void save_held(ByteWriter& out) const;
  void load_held(ByteReader& in);
};

inline constexpr std::uint8_t stylus_hand = 2;   // of a HandRef: what presses by a stylus
inline constexpr std::size_t most_fingers = 64;  // segments of a hand
inline constexpr double stylus_radius = 0.003;   // m
inline constexpr double stylus_length = 0.1;     // m of its shaft that panels feel
inline constexpr double tablet_rest = 3;         // s that a panel lies where its tablet was seen last
inline constexpr double touch_moment = 0.25;     // s that a hand touches a part before its panel comes up
inline constexpr double panel_patience = 10;     // s without touch until it goes
inline constexpr double pinned_by_hand = 0.5;    // s that it stays after a finger pointed at it …
inline constexpr double pinned_from_afar = 1.5;  // … and after its owner asked for it again
inline constexpr double pointing_reach = 0.5;    // m from a fingertip to what it points at
inline constexpr double second_fist = 1;         // s within which a second fist at the head puts it back …
inline constexpr double second_fist_way = 0.03;  // … unless the palm moved so far, m
inline constexpr double closing_bend = 0.5;     // of all four fingers: a hand that closes; it presses nothing
inline constexpr double closing_at_head = 0.2;  // the same while it reaches a panel's head
inline constexpr double pointed_time = 0.3;     // s that a control that was set from afar shows it
inline constexpr double home_position = 0.85;  // of its way: from here on a button counts as pressed home …
inline constexpr double let_go_position = 0.4;  // … and from here back as let go

}  // namespace prosector
