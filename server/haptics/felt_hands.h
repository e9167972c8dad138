#pragma once
// Contact planes of all hands that haptic arms move, after each tick. Reads the simulation and does not
// change it.

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "server/haptics/compliance_worker.h"
#include "server/haptics/felt_hand.h"

namespace prosector {

/// A hand that a haptic arm moves, and the sequence number of its newest input that the tick has consumed.
struct FeelingHand {
  HandRef hand;
  std::uint64_t input_sequence = 0;
};

class FeltHands {
 public:
  /// Updates the contact planes of all `hands` after a tick. Returns one message for the haptic arm of each
  /// hand, even if it has no planes.
  std::vector<FeltPlanes> follow(const Simulation& simulation, std::span<const FeelingHand> hands);

 private:
  void ask(const Simulation& simulation);
  void take_answers();

  std::map<HandRef, FeltHand> hands_;
  std::map<BodyId, std::uint64_t> copied_;  // version of each body's copy that the worker has
  BodyId last_asked_ = 0;
  std::unique_ptr<ComplianceWorker> worker_;  // null: no hand has touched tissue yet
};

}  // namespace prosector
