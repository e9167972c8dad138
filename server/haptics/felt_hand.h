#pragma once
// Contact planes of one hand that a haptic arm moves, from tick to tick.

#include <optional>
#include <span>
#include <vector>

#include "server/haptics/compliance_worker.h"
#include "server/haptics/touch_groups.h"

namespace prosector {

inline constexpr double hard_stiffness =
    2000;  // N/m, rendered for rigid bodies: haptic arms display this stiffness well

class FeltHand {
 public:
  explicit FeltHand(const HandRef& ref) : ref_(ref) {}

  const HandRef& ref() const { return ref_; }
  /// Updates the hand's contact planes after a tick. Returns the message for the haptic arm, with the
  /// stiffnesses that have been computed so far.
  FeltPlanes follow(const Simulation& simulation, const HandState& hand);

  /// Returns the supports (pressing contacts and holds) of the soft bodies that the hand touches.
  const std::vector<Support>& supports() const { return around_.supports; }
  /// Appends a patch of contact points for each of the hand's contact planes on that soft body to `patches`,
  /// and the patches' numbers to `names`.
  void patches_on(BodyId body, std::vector<Patch>& patches, std::vector<std::uint64_t>& names) const;
  /// Stores the computed stiffnesses of `answer` in those contact planes of the hand that it refers to.
  void take(const ComplianceAnswer& answer);

 private:
  struct Place {
    std::uint32_t id = 0;
    TouchGroup group;
    std::optional<Slopes> slopes;  // computed by the worker; none: not yet
    double surface = 0;            // m, along the normal: position of the surface without this hand's force
    double speed = 0;              // m/s: smoothed rate of `surface`
    bool known = false;            // whether `surface` is set
  };

  bool others_act(BodyId body) const;
  Slopes slopes_of(const Simulation& simulation, const Place& place) const;
  ContactPlane plane_of(const Simulation& simulation, const Pose& hand, const Vec3& all, Place& place) const;
  void count_energy(const HandState& hand);
  std::uint64_t name_of(const Place& place) const;

  HandRef ref_;
  HandSurroundings around_;  // after the last tick
  std::vector<Place> places_;
  std::uint32_t last_id_ = 0;
  std::optional<Vec3> last_point_;  // m, room frame: the hand's position after the last tick
  double taken_ = 0, given_ = 0;    // J: work of the hand on bodies, and of bodies on the hand
};

}  // namespace prosector
