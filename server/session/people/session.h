#pragma once
// The session: converts received samples to the inputs of a tick. It reads no clock and knows no network;
// time is the tick, so a journal of what it returned replays the run.
//
// Joining takes Presence (the client's identity) and Command join (its request), in either order. The answer
// is a CommandResult, and a RosterEntry informs everyone. A participant's id belongs to the process that used
// it first: samples from another process in its name are refused and counted.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "idl/bus.h"
#include "server/physics/simulation.h"
#include "server/session/people/command_count.h"
#include "server/session/people/lost_holds.h"
#include "server/session/people/moments.h"
#include "server/session/people/pacing.h"
#include "server/session/people/panel_inputs.h"
#include "server/session/people/roster.h"
#include "server/session/people/sequence_gate.h"

namespace prosector {

/// A message that the server publishes to clients, or the end (disposal) of the message's DDS instance.
struct Outgoing {
  Message message;
  bool dispose = false;  // dispose of the instance instead
};

/// A participant, and the sequence number of its newest input that the tick consumed.
struct InputKey {
  ParticipantId participant = 0;
  std::uint64_t sequence = 0;
};

/// All inputs that a tick consumes, in the form that is stored in the journal.
struct ConsumedInput {
  TickInput input;
  std::vector<InputKey> keys;
};

/// An entry of the session's log, such as a join, a refusal or a changed role.
struct SessionEvent {
  enum class Kind : std::uint8_t {
    joined,
    refused,
    left,
    lost,
    hand_timeout,
    role,
    let_go,
    broke,
    rewound,
    pace,
    effort,
    accuracy,
    hand_stalled
  } kind;
  ParticipantId participant = 0;
  std::string name;
  std::string detail;  // by kind: the role, the reason, the hand, or the target
};

/// A request of the host to change the accuracy with which a body is simulated.
struct AccuracyRequest {
  ParticipantId participant = 0;
  SetAccuracy wanted;
};

class Session {
 public:
  explicit Session(const SessionRules& rules);

  /// Processes the messages that were received before `tick`. Returns the inputs of that tick's step, in
  /// canonical order.
  ConsumedInput consume(std::span<const Received> received, std::uint64_t tick);
  /// Processes messages that were received while simulated time is stopped: joins, leaves, and the host's
  /// control of time.
  void listen(std::span<const Received> received);
  /// Answers participants' commands after the step. Whether a grasp succeeded follows from the bodies that
  /// `hands` hold now; commands for anatomical parts and cuts are answered from `report`.
  void finish_tick(std::span<const HandState> hands, const StepReport& report = {});

  /// Updates the list of open control panels after the step. Panels that their owner may no longer use close
  /// at the next tick.
  void see_panels(std::span<const Panel> panels) { panels_.finish_tick(panels); }

  const Pacing& pacing() const { return pacing_; }
  /// Sets the pace (simulated seconds per real second) until a participant changes it; 0: simulated time is
  /// stopped.
  void set_pace(double pace) { pacing_.set(pace); }
  /// Returns the tick of the played recording to which a viewer asked to jump most recently since the last
  /// call. Returns nullopt if there was no such request.
  std::optional<std::uint64_t> take_seek() { return std::exchange(seek_, std::nullopt); }
  std::size_t bodies() const { return rules_.bodies; }
  /// Adds a body that a cut has created; it gets the next id. `is_part`: whether it is a part of the anatomy.
  void add_body(const std::string& name, bool is_part);
  /// Returns, in order, the host's requests since the last call to change the accuracy of bodies.
  std::vector<AccuracyRequest> take_accuracy_wishes() { return std::exchange(accuracy_wishes_, {}); }
  /// Queues a message with text `words` for a participant. It is not the answer to a command.
  void tell(ParticipantId participant, const std::string& words);
  /// Returns the stored states of the simulation to which the host can rewind.
  Moments& moments() { return moments_; }
  /// Returns the bodies for which clients requested a keyframe (the complete surface) since the last call.
  std::set<BodyId> take_keyframe_requests();

  /// Makes these hands vanish at the next tick. They come from a restored state, and no member of the session
  /// owns them.
  void vanish(std::span<const HandState> hands);

  std::vector<Outgoing> take_outgoing();
  std::vector<SessionEvent> take_events();

  const Roster& roster() const { return roster_; }
  /// Returns the newest hand input of a participant, from which its published UserState is made. Null before
  /// the first input.
  const HandInput* newest_input(ParticipantId id) const;
  std::uint64_t hand_timeouts() const { return hand_timeouts_; }
  /// Returns the number of received messages that were dropped as invalid, by reason.
  const std::map<std::string, std::uint64_t>& dropped() const { return dropped_; }
  std::uint64_t dropped_total() const { return dropped_total_; }
  /// Returns the numbers of commands that were granted and refused, by kind of command.
  const CommandCounts& commands() const { return commands_; }

 private:
  friend class MemberCommand;  // both execute commands of members: session_commands.cpp
  friend class CommandHandler;
  static constexpr std::size_t max_events = 4096;  // limit between two ticks

  enum class Loss : std::uint8_t { none, untracked, stalled };
  struct Hand {
    bool present = false;
    std::uint64_t tracked_tick = 0;
    HandTarget target;
    Loss loss = Loss::none;               // why the hand vanished in this tick
    std::optional<BodyId> regrasps = {};  // body that it grasps again in this tick, after a stall
  };
  struct Reaction {  // force of a haptic arm
    SequenceGate sequences = {};
    std::uint64_t tick = 0;  // tick of the newest sample
    double force = 0;        // N
  };
  struct PendingGrasp {
    Command command;
    std::uint8_t hand = right_hand;
  };
  struct PendingPart {
    Command command;
    PartEvent event;
  };
  struct PendingCut {
    Command command;
    CutEvent event;
    std::string rewinds_to;  // for the log; empty: an undo
  };
  struct Seat {  // state of a member
    std::optional<HandInput> input;
    SequenceGate sequences;
    bool fresh = false;
    std::uint64_t heard_tick = 0;  // tick of the newest input
    std::array<Hand, 2> hands;
    std::vector<HandEvent> asked;       // requested by its commands since the last tick
    std::array<bool, 2> opens{};        // hands that a command opened in this tick
    std::vector<PendingGrasp> grasps;   // waiting for the step
    std::vector<PendingPart> parts;     // waiting for the step
    std::vector<PendingCut> cuts;       // waiting for the step
    std::uint32_t commands = 0;         // in this tick
    std::array<Reaction, 2> reactions;  // forces of haptic arms, by hand
  };
  struct Visitor {  // a sender that isn't a member (yet, or any more)
    std::uint64_t writer = 0;
    std::uint64_t seen = 0;  // tick of the newest sample
    std::optional<Presence> presence;
    std::optional<Command> join;
    std::uint64_t join_tick = 0;
  };

  SessionRules rules_;
  Roster roster_;
  ReleasedHolds lost_holds_;
  std::set<ParticipantId> cut_off_;  // members whose connection broke since the last step
  std::map<ParticipantId, Seat> seats_;
  std::map<ParticipantId, Visitor> visitors_;
  std::vector<HandEvent> vanishing_;
  std::vector<EffortChange> efforts_;  // requested by the host
  std::vector<AccuracyRequest> accuracy_wishes_;
  std::vector<Command> stepping_;    // part commands whose events this tick consumes, in order
  std::vector<PendingCut> cutting_;  // cut commands whose events this tick consumes, in order
  std::set<BodyId> keyframes_;       // bodies with a requested keyframe
  PanelInputs panels_;
  Moments moments_;
  Pacing pacing_;
  std::optional<std::uint64_t> seek_;
  std::vector<Outgoing> outgoing_;
  std::vector<SessionEvent> events_;
  std::map<std::string, std::uint64_t> dropped_;
  CommandCounts commands_{};
  std::uint64_t dropped_total_ = 0, hand_timeouts_ = 0, tick_ = 0;

  void take_all(std::span<const Received> received);
  void take(const Received& received);
  void take(const Presence& presence, const Received& received);
  void take(const HandInput& input, std::uint64_t writer);
  void take(const Command& command, std::uint64_t writer);
  void take(const ArmForce& force, std::uint64_t writer);
  std::optional<double> reaction(ParticipantId id, const Seat& seat, std::size_t hand) const;
  void take_of_visitor(const Command& command, std::uint64_t writer);
  void obey(const Command& command, const Participant& member, Seat& seat);
  void give(ParticipantId id, Role role);
  void vanish_hands(ParticipantId id, Seat& seat);
  void settle_joins();
  void try_join(ParticipantId id, Visitor& visitor);
  void leave(ParticipantId id, SessionEvent::Kind how);
  void consume_seat(ParticipantId id, Seat& seat, ConsumedInput& out);
  void consume_hand(ParticipantId id, std::size_t hand, Seat& seat, TickInput& out);
  Visitor* visitor(ParticipantId id, std::uint64_t writer, const char* what);
  void forget_visitors();
  void answer(const Command& command, const Refusal& refusal);
  bool admits(SequenceGate& sequences, std::uint64_t number, const char* what);
  std::string name_of(BodyId body) const;
  void take_loss(const LetGo& let_go);
  void tell_of_loss(const LetGo& let_go);
  void finish_hands(std::span<const HandState> hands);
  void drop(const char* reason);
};

}  // namespace prosector
