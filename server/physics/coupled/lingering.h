#pragma once
// Bodies that stay where they are without coming to rest. Contacts that can't all be had at once, of layers
// that are through each other say, put back what damping takes, and such a body would shiver for ever.

#include <cstdint>
#include <map>
#include <optional>

#include "common/math.h"
#include "common/messages.h"
#include "server/physics/soft/soft_body.h"

namespace prosector {

struct Lingering {
  VecX place;     // m: of a soft body's nodes, or of points of a rigid one, when it was first seen to linger
  int ticks = 0;  // since then
};

enum class Unrest : std::uint8_t { moving, calmed, over };

/// A body, and where it is now.
struct Lingerer {
  BodyId body = 0;
  VecX place;         // m, room frame
  double within = 0;  // m: from where it was, along each axis
};

/// Follows bodies from tick to tick. Checkpoints hold it.
class Lingerers {
 public:
  using Map = std::map<BodyId, Lingering>;

  explicit Lingerers(double h) : h_(h) {}  // s: a tick

  /// Begins a tick. Who is not asked about in it is forgotten at its end.
  void begin_tick(std::uint64_t tick);
  /// Says whether the body is on the move, has lingered long enough to be calmed, or so long that its unrest
  /// is over. Only at whole seconds does it begin to watch a body.
  Unrest linger(const Lingerer& now);
  void end_tick() { watched_.swap(next_); }

  /// Returns those that the next tick calms or ends, should they linger on.
  Map calmed_next() const;
  const Map& watched() const { return watched_; }
  void set(Map watched) { watched_ = std::move(watched); }
  void forget(BodyId body) { watched_.erase(body); }
  void forget_from(BodyId first) { watched_.erase(watched_.lower_bound(first), watched_.end()); }

 private:
  Map watched_, next_;
  bool may_begin_ = false;
  double h_;  // s
};

/// Returns how far (m) the nodes of a body that touches something may go while it lingers: a cell of what is
/// thin, which sways; else a tenth. A thin one that touches nothing may go a tenth; other bodies that touch
/// nothing don't linger.
std::optional<double> lingering_bound(const SoftBody& body, bool touches);
/// m: how far a lingering rigid body's points may go where it touches tissue, and where it doesn't.
inline constexpr double rigid_lingering_bound = 2e-3, lone_lingering_bound = 5e-3;
inline constexpr Eigen::Index pose_numbers = 9;
/// Returns points of a rigid body that tell its pose: pose_numbers, m.
VecX points_of(const Pose& pose);

/// What a calmed body keeps of its velocity in each tick.
inline constexpr double calming = 0.9;

}  // namespace prosector
