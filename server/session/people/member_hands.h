#pragma once
// Hands of the members: which are in the room, what they lost hold of, and whether they grasp it again.

#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "server/physics/simulation.h"
#include "server/session/people/lost_holds.h"
#include "server/session/people/roster.h"
#include "server/session/people/seat.h"
#include "server/session/people/session_output.h"

namespace prosector {

class MemberHands {
 public:
  explicit MemberHands(const SessionRules& rules)
      : input_timeout_(rules.input_timeout),
        stall_timeout_(rules.stall_timeout),
        lost_holds_(rules.regrasp_timeout) {}

  /// Makes each hand of a member appear, follow its newest pose, or vanish, by events and targets in the
  /// inputs `out` of `tick`. A stalled client's hands stay where they are, with what they hold, until
  /// `stall_timeout`.
  void consume(const Participant& member, Seat& seat, std::uint64_t tick, TickInput& out,
               SessionOutput& output);

  /// Makes the hands of a participant that leaves or becomes an observer vanish at the next tick.
  void vanish(ParticipantId id, const Seat& seat);
  /// Makes these hands vanish at the next tick. They come from a restored state, and no member of the session
  /// owns them.
  void vanish(std::span<const HandState> hands);
  /// Returns the events of vanish() since the last call, in canonical order.
  std::vector<HandEvent> take_vanishing();

  /// Remembers until the end of the tick that the participant's connection broke: its hands may grasp again
  /// what they lose.
  void cut_off(ParticipantId id) { cut_off_.insert(id); }
  /// Forgets the body that a hand lost, since its user opened the hand or grasps another body.
  void forget_hold(const HandRef& hand) { lost_holds_.forget(hand); }
  /// Returns the bodies that the participant's hands lost and may grasp again.
  std::vector<ReleasedHolds::Lost> lost_by(ParticipantId id) const { return lost_holds_.of(id); }
  /// Remembers the lost hold if the hand may grasp the body again: after a stall or a broken connection.
  /// `seat`: the participant's; null if it is no longer a member.
  void note_loss(const LetGo& let_go, const Seat* seat, std::uint64_t tick);
  /// Ends the tick. Returns bodies that a hand lost when its client's input stopped and any hand holds now.
  std::vector<ReleasedHolds::Lost> finish_tick(std::span<const HandState> hands, std::uint64_t tick);

  /// Returns how often a hand vanished because its client did not track it or sent nothing.
  std::uint64_t timeouts() const { return timeouts_; }

 private:
  std::uint64_t input_timeout_, stall_timeout_;
  ReleasedHolds lost_holds_;
  std::set<ParticipantId> cut_off_;  // members whose connection broke since the last step
  std::vector<HandEvent> vanishing_;
  std::uint64_t timeouts_ = 0;

  void consume_hand(const Participant& member, std::size_t hand, Seat& seat, std::uint64_t tick,
                    TickInput& out, SessionOutput& output);
};

/// Informs the user that the hand lost its hold, unless a command opened it or the user is an observer now.
void tell_of_loss(const LetGo& let_go, const Seat& seat, const SessionRules& rules, SessionOutput& output);

/// Informs the member if a hand could not grasp again the body that it lost while the member's client was
/// silent. `hands` are those after the simulation step.
void finish_regrasps(ParticipantId id, Seat& seat, std::span<const HandState> hands,
                     const SessionRules& rules, SessionOutput& output);

/// Answers the member's grasps after the step: whether its hands hold a body or carry a panel now.
void answer_grasps(ParticipantId id, Seat& seat, std::span<const HandState> hands, const StepReport& report,
                   SessionOutput& output);

}  // namespace prosector
