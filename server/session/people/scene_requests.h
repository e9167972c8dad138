#pragma once
// Requests of commands that take effect outside of the session: cuts, parts and solver effort in the
// simulation, and requests to the server loop.

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "common/commands.h"
#include "server/physics/simulation.h"
#include "server/session/people/roster.h"
#include "server/session/people/seat.h"
#include "server/session/people/session_output.h"

namespace prosector {

/// A request of the host to change the accuracy with which a body is simulated.
struct AccuracyRequest {
  ParticipantId participant = 0;
  SetAccuracy wanted;
};

class SceneRequests {
 public:
  /// Requests a solver effort from the next tick on.
  void change_effort(const EffortChange& change) { efforts_.push_back(change); }
  void change_accuracy(const AccuracyRequest& request) { accuracies_.push_back(request); }
  /// Requests the complete surface of a body.
  void send_keyframe(BodyId body) { keyframes_.insert(body); }
  /// Requests a jump to a tick of the played recording. Replaces an earlier request.
  void seek(std::uint64_t tick) { seek_ = tick; }

  /// Returns, in order, the changes of solver effort that were requested since the last call.
  std::vector<EffortChange> take_efforts() { return std::exchange(efforts_, {}); }
  /// Returns, in order, the host's requests since the last call to change the accuracy of bodies.
  std::vector<AccuracyRequest> take_accuracies() { return std::exchange(accuracies_, {}); }
  /// Returns the bodies for which clients requested a keyframe (the complete surface) since the last call.
  std::set<BodyId> take_keyframes() { return std::exchange(keyframes_, {}); }
  /// Returns the tick of the played recording to which a viewer asked to jump most recently since the last
  /// call. Returns nullopt if there was no such request.
  std::optional<std::uint64_t> take_seek() { return std::exchange(seek_, std::nullopt); }

  /// Moves a member's waiting commands for parts and cuts to the inputs `out` of a tick.
  void consume(Seat& seat, TickInput& out);
  /// Answers the commands that the tick consumed from the report of its step.
  void finish_tick(const StepReport& report, const Roster& roster, SessionOutput& output);

 private:
  std::vector<EffortChange> efforts_;
  std::vector<AccuracyRequest> accuracies_;
  std::set<BodyId> keyframes_;
  std::optional<std::uint64_t> seek_;
  std::vector<Command> stepping_;    // part commands whose events this tick consumes, in order
  std::vector<PendingCut> cutting_;  // cut commands whose events this tick consumes, in order
};

}  // namespace prosector
