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

  /// Sets for how many ticks a loss is remembered.
  explicit ReleasedHolds(std::uint64_t ticks) : ticks_(ticks) {}

  /// Stores the body that a hand lost at `tick`.
  void note(const HandRef& hand, BodyId body, std::uint64_t tick) { lost_[hand] = {body, tick}; }
  /// Forgets the loss of a hand: its user opened it, or grasped something else.
  void forget(const HandRef& hand) { lost_.erase(hand); }
  /// Returns the body that a returned hand may grasp again, and forgets it; nullopt: none.
  std::optional<BodyId> take(const HandRef& hand);
  /// Returns the losses of a participant's hands.
  std::vector<Lost> of(ParticipantId participant) const;
  /// Forgets old losses, and losses of bodies that a hand holds now. Returns the latter.
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
