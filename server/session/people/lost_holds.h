#pragma once
// Remembers the bodies that hands lost because their client stalled or its connection broke, so that the
// hands can grasp them again.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "server/physics/simulation.h"

namespace prosector {

class ReleasedHolds {
 public:
  struct Lost {
    HandRef hand;
    BodyId body = 0;
  };

  /// Remembers lost holds of hands for `ticks` ticks.
  explicit ReleasedHolds(std::uint64_t ticks) : ticks_(ticks) {}

  /// Stores that the hand lost `body`, which it held, at `tick`, so that it can grasp it again.
  void note(const HandRef& hand, BodyId body, std::uint64_t tick) { lost_[hand] = {body, tick}; }
  /// Forgets the body that a hand lost, since its user opened the hand or grasped another body.
  void forget(const HandRef& hand) { lost_.erase(hand); }
  /// Returns the body that a hand lost and may grasp again now that its client is back, and forgets it.
  /// Returns nullopt if there is none.
  std::optional<BodyId> take(const HandRef& hand);
  /// Returns the bodies that the participant's hands lost, each with the hand.
  std::vector<Lost> of(ParticipantId participant) const;
  /// Forgets bodies that were lost too long ago, and those that any hand holds now. Returns the latter.
  /// `tick` is the current tick.
  std::vector<Lost> follow(std::span<const HandState> hands, std::uint64_t tick);

 private:
  struct Entry {
    BodyId body = 0;
    std::uint64_t tick = 0;
  };
  std::uint64_t ticks_;
  std::map<HandRef, Entry> lost_;
};

}  // namespace prosector
