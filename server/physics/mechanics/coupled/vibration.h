#pragma once
// Bodies that stay in place without coming to rest. Contacts that can't all be satisfied simultaneously, for
// example of interpenetrating layers, return the energy that damping removes. Such a body would vibrate
// forever.

#include <cstdint>
#include <map>
#include <optional>

#include "common/ids.h"
#include "common/math.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {

/// Stored position of a watched body.
struct StuckBody {
  VecX place;     // m: node positions of a soft body, or points of a rigid one, when watching began
  int ticks = 0;  // number of ticks since then
};

enum class VibrationState : std::uint8_t { moving, calmed, over };

/// A body and its current position.
struct WatchedBody {
  BodyId body = 0;
  VecX place;         // m, room frame
  double within = 0;  // m: largest displacement along each axis while lingering
};

/// Watches bodies from tick to tick. Part of checkpoints.
class Lingerers {
 public:
  using Map = std::map<BodyId, StuckBody>;

  explicit Lingerers(double h) : h_(h) {}  // h: s, a tick

  /// Begins a tick. Bodies without a call of linger() are forgotten at its end.
  void begin_tick(std::uint64_t tick);
  /// Returns whether the body moves, has lingered long enough to be calmed, or so long that it must be
  /// stopped. Watching a body begins only in ticks at whole seconds.
  VibrationState linger(const WatchedBody& now);
  void end_tick() { watched_.swap(next_); }

  /// Returns the bodies that the next tick will calm or stop if they still linger.
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

/// Returns how far (m) the nodes of a lingering body may move. A thin body in contact sways, and may move by
/// a cell. A thin body without contact, or a solid in contact, may move by a tenth of a cell. A solid without
/// contact does not linger: none.
std::optional<double> lingering_bound(const SoftBody& body, bool touches);
/// m: how far the points of a lingering rigid body may move with and without contact with tissue.
inline constexpr double rigid_lingering_bound = 2e-3, lone_lingering_bound = 5e-3;
inline constexpr Eigen::Index pose_numbers = 9;
/// Returns three points of a rigid body that determine its pose: pose_numbers values, m.
VecX points_of(const Pose& pose);

/// Factor on a calmed body's velocity in each tick.
inline constexpr double calming = 0.9;

}  // namespace prosector
