#pragma once
// One hand that an arm moves: its contact planes from tick to tick.

#include <optional>
#include <span>
#include <vector>

#include "server/haptics/compliance_worker.h"
#include "server/haptics/touch_groups.h"

namespace prosector {

inline constexpr double hard_stiffness = 2000;  // N/m, of what is rigid: arms show that well

class FeltHand {
 public:
  explicit FeltHand(const HandRef& ref) : ref_(ref) {}

  const HandRef& ref() const { return ref_; }
  /// Takes what the hand meets now. Returns what is felt, with the stiffnesses that are known.
  FeltPlanes follow(const Simulation& simulation, const HandState& hand);

  /// Returns what bears the soft bodies that it meets.
  const std::vector<Support>& supports() const { return around_.supports; }
  /// Returns a patch for each of its planes on that soft body, and their ids.
  void patches_on(BodyId body, std::vector<Patch>& patches, std::vector<std::uint64_t>& names) const;
  /// Takes how far a body gives way under its planes.
  void take(const ComplianceAnswer& answer);

 private:
  struct Place {
    std::uint32_t id = 0;
    TouchGroup group;
    std::optional<Slopes> slopes;  // as the body was found to have; none: it was not asked yet
    double surface = 0;            // m, along the normal: where it would be without this hand
    double speed = 0;              // m/s, of that, smoothed
    bool known = false;            // `surface` is
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
  std::optional<Vec3> last_point_;  // m, room: where the hand was
  double taken_ = 0, given_ = 0;    // J
};

}  // namespace prosector
