#pragma once
// Saved states ("moments") to which the host can rewind: one for every tick that changed a topology, within a
// memory budget.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/ids.h"

namespace prosector {

inline constexpr std::size_t moments_budget = 256 * 1024 * 1024;  // bytes of states

class Moments {
 public:
  using State = std::shared_ptr<const std::vector<std::uint8_t>>;
  struct Revision {  // a revision that a body reached
    BodyId body = 0;
    std::uint32_t revision = 0;
  };

  explicit Moments(std::size_t budget = moments_budget) : budget_(budget) {}

  /// Stores the simulation's state at `tick`, in which these bodies had just reached these topology
  /// revisions. Calls are in the order of ticks. Beyond the memory budget, older states are dropped where
  /// they are densest for their age. The first and the newest are always stored.
  void keep(std::uint64_t tick, std::vector<Revision> revisions, std::vector<std::uint8_t> state);
  /// Returns the saved state in which the body had just reached that topology revision. Null if it is not
  /// stored.
  State find(BodyId body, std::uint32_t revision) const;
  /// Returns the saved state that was stored first. Null if there is none.
  State first() const { return moments_.empty() ? nullptr : moments_.front().state; }
  /// Returns, as text, the topology revisions of a body for which states are stored, such as "0, 3 to 7 and
  /// 9".
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
