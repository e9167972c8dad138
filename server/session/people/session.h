#pragma once
// The session: converts received samples to the inputs of a tick. It reads no clock and knows no network;
// time is the tick, so a journal of what it returned replays the run.
//
// Joining takes Presence (the client's identity) and Command join (its request), in either order. The answer
// is a CommandResult, and a RosterEntry informs everyone. A participant's id belongs to the process that used
// it first: samples from another process in its name are refused and counted.

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "idl/bus.h"
#include "server/physics/simulation.h"
#include "server/session/people/member_hands.h"
#include "server/session/people/moments.h"
#include "server/session/people/pacing.h"
#include "server/session/people/panel_inputs.h"
#include "server/session/people/roster.h"
#include "server/session/people/scene_requests.h"
#include "server/session/people/seat.h"
#include "server/session/people/session_output.h"
#include "server/session/people/visitors.h"

namespace prosector {

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
  std::size_t bodies() const { return rules_.bodies; }
  /// Adds a body that a cut has created; it gets the next id. `is_part`: whether it is a part of the anatomy.
  void add_body(const std::string& name, bool is_part);
  /// Returns the stored states of the simulation to which the host can rewind.
  Moments& moments() { return moments_; }

  /// Makes these hands vanish at the next tick. They come from a restored state, and no member of the session
  /// owns them.
  void vanish(std::span<const HandState> hands) { hands_.vanish(hands); }

  /// Returns what commands requested of the server since it was last taken.
  SceneRequests& requests() { return requests_; }
  /// Returns the messages, events and counts of the session.
  SessionOutput& output() { return output_; }
  const SessionOutput& output() const { return output_; }

  const Roster& roster() const { return roster_; }
  /// Returns the newest hand input of a participant, from which its published UserState is made. Null before
  /// the first input.
  const HandInput* newest_input(ParticipantId id) const;
  /// Returns how often a hand vanished because its client did not track it or sent nothing.
  std::uint64_t hand_timeouts() const { return hands_.timeouts(); }

 private:
  friend class MemberCommand;  // both execute commands of members: session_commands.cpp
  friend class CommandHandler;

  SessionRules rules_;
  Roster roster_;
  std::map<ParticipantId, Seat> seats_;  // of the members
  Visitors visitors_;
  MemberHands hands_;
  PanelInputs panels_;
  SceneRequests requests_;
  Moments moments_;
  Pacing pacing_;
  SessionOutput output_;
  std::uint64_t tick_ = 0;

  void take(const Received& received);
  void take(const Presence& presence, const Received& received);
  void take_end(const Presence& presence, std::uint64_t writer);
  void take(const HandInput& input, std::uint64_t writer);
  void take(const Command& command, std::uint64_t writer);
  void take(const ArmForce& force, std::uint64_t writer);
  void take(const LetGo& let_go);
  void take_of_visitor(const Command& command, std::uint64_t writer);
  void give(ParticipantId id, Role role);
  void settle_join(ParticipantId id, Visitor& visitor);
  void leave(ParticipantId id, SessionEvent::Kind how);
  void consume_seat(ParticipantId id, Seat& seat, ConsumedInput& out);
};

}  // namespace prosector
