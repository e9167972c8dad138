#pragma once
// All hands that arms move: what each feels after a tick. It reads the simulation and changes nothing in it.

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "server/haptics/compliance_worker.h"
#include "server/haptics/felt_hand.h"

namespace prosector {

/// A hand that is to be told, and the newest of its inputs that the tick consumed.
struct FeelingHand {
  HandRef hand;
  std::uint64_t input_sequence = 0;
};

class FeltHands {
 public:
  /// Goes on after a tick. Returns a message for each hand, planes or not.
  std::vector<FeltPlanes> follow(const Simulation& simulation, std::span<const FeelingHand> hands);

 private:
  void ask(const Simulation& simulation);
  void take_answers();

  std::map<HandRef, FeltHand> hands_;
  std::map<BodyId, std::uint64_t> copied_;  // version of each body's copy that the worker has
  BodyId last_asked_ = 0;
  std::unique_ptr<ComplianceWorker> worker_;  // null: no hand felt tissue yet
};

}  // namespace prosector
