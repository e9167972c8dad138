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

namespace prosector::coupled {

/// Record of a body that may vibrate in place without coming to rest: its position when watching began, and
/// for how many ticks it has stayed there.
struct StuckBody {
  VecX place;     // m: node positions of a soft body, or points of a rigid one, when watching began
  int ticks = 0;  // number of ticks since then
};

enum class VibrationState : std::uint8_t { moving, calmed, over };

/// Body to be checked for vibrating in place: its current points, and the largest displacement per axis (m)
/// with which it still counts as staying in place.
struct WatchedBody {
  BodyId body = 0;
  VecX place;         // m, room frame
  double within = 0;  // m: largest displacement along each axis while lingering
};

/// Detector of bodies that linger: that stay in place without coming to rest, since contradictory contacts
/// make them vibrate. It stores the watched bodies from tick to tick and is part of checkpoints.
class Lingerers {
 public:
  using Map = std::map<BodyId, StuckBody>;

  explicit Lingerers(double h) : h_(h) {}  // h: s, a tick

  /// Begins the tick with this number. Bodies for which linger() is not called before end_tick() are no
  /// longer watched afterwards.
  void begin_tick(std::uint64_t tick);
  /// Returns `calmed` if the body has stayed in place for more than 2 s, and its velocity is to be damped.
  /// Returns `over` after 2.5 s, when it must be stopped; otherwise `moving`. Watching begins only at whole
  /// seconds and restarts when the body moves away.
  VibrationState linger(const WatchedBody& now);
  void end_tick() { watched_.swap(next_); }

  /// Returns the watched bodies that the next tick will calm (damp) or stop if they still stay in place.
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

/// Returns how far (m, per axis) the nodes of a soft body may move while it counts as staying in place.
/// `touches`: whether it is in contact. A sheet or rope in contact sways, and may move by one cell of its
/// mesh. Without contact, or for a solid in contact, it is a tenth of a cell. None for a solid without
/// contact, which is never stopped for vibrating.
std::optional<double> lingering_bound(const soft::SoftBody& body, bool touches);
/// Distances (m, per axis) within which the points of a rigid body may move while it counts as staying in
/// place. `rigid_lingering_bound` applies to bodies in contact with tissue, `lone_lingering_bound` to others.
inline constexpr double rigid_lingering_bound = 2e-3, lone_lingering_bound = 5e-3;
inline constexpr Eigen::Index pose_numbers = 9;
/// Returns the positions (m) of three points of a rigid body that determine its pose: its origin, and the
/// points 0.1 m along its x and y axes. The vector has pose_numbers = 9 values.
VecX points_of(const Pose& pose);

/// Factor by which the velocity of a body that vibrates in place is multiplied in each tick, to calm it.
inline constexpr double calming = 0.9;

}  // namespace prosector::coupled
