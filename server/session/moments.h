#pragma once
// States that the host can go back to: one for every tick that changed a topology, as far as memory goes.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/messages.h"

namespace prosector {

inline constexpr std::size_t moments_budget = 256 * 1024 * 1024;  // bytes of states

class Moments {
 public:
  using State = std::shared_ptr<const std::vector<std::uint8_t>>;
  struct Revision {  // that a body got
    BodyId body = 0;
    std::uint32_t revision = 0;
  };

  explicit Moments(std::size_t budget = moments_budget) : budget_(budget) {}

  /// Keeps the state in which these bodies had just got these revisions, in order of ticks. Where states take
  /// more than the budget, older ones give way where they are densest for their age; the first and the newest
  /// stay.
  void keep(std::uint64_t tick, std::vector<Revision> revisions, std::vector<std::uint8_t> state);
  /// Returns the state; null: not kept.
  State find(BodyId body, std::uint32_t revision) const;
  /// Returns the first state that was kept; null: none.
  State first() const { return moments_.empty() ? nullptr : moments_.front().state; }
  /// Returns, for people, which revisions of a body there are states of: "0, 3 to 7 and 9".
  std::string kept(BodyId body) const;
  std::size_t bytes() const { return bytes_; }

 private:
  struct Moment {
    std::uint64_t tick = 0;
    std::vector<Revision> revisions;
    State state;
  };
  std::size_t budget_, bytes_ = 0;
  std::vector<Moment> moments_;  // by tick

  void thin_out();
};

}  // namespace prosector
