#pragma once
// What hands lost because their client stalled or its connection broke, so that they can have it back.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "server/physics/simulation.h"

namespace prosector {

class LostHolds {
 public:
  struct Lost {
    HandRef hand;
    BodyId body = 0;
  };

  /// Takes for how many ticks a loss is remembered.
  explicit LostHolds(std::uint64_t ticks) : ticks_(ticks) {}

  /// Remembers what a hand lost at `tick`.
  void note(const HandRef& hand, BodyId body, std::uint64_t tick) { lost_[hand] = {body, tick}; }
  /// Forgets a hand: its user opened it, or grasped something else.
  void forget(const HandRef& hand) { lost_.erase(hand); }
  /// Returns the body that a hand which is back may have again, and forgets it; nullopt: none.
  std::optional<BodyId> take(const HandRef& hand);
  /// Returns what the hands of a participant lost.
  std::vector<Lost> of(ParticipantId participant) const;
  /// Forgets old losses, and those of bodies that another hand holds by now. Returns the latter.
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
