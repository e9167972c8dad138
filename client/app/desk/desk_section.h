#pragma once
// Clipping plane of a desk user. A key opens it; the wheel moves it while the key is held; pressing the key
// again without the wheel closes it.

#include <optional>

#include "client/view/section.h"

namespace prosector {

class DeskSection {
 public:
  /// Handles the press of the key: opens the section plane through `middle` (m), facing the eye. `back`: unit
  /// vector towards the eye. If the plane is open already, the key's release will close it unless the plane
  /// is moved.
  void press(const Vec3& back, const Vec3& middle) {
    closes_ = plane_.has_value();
    if (!closes_) plane_ = section_facing(back, middle);
  }
  void let_go() {
    if (closes_) plane_.reset();
    closes_ = false;
  }
  /// Moves the section plane by 3 mm per wheel notch: away from the eye for positive values, towards it for
  /// negative ones.
  void move(double notches) {
    closes_ = false;
    if (plane_) plane_->offset -= meters_per_notch * notches;
  }
  const std::optional<SectionPlane>& plane() const { return plane_; }

 private:
  static constexpr double meters_per_notch = 0.003;

  std::optional<SectionPlane> plane_;
  bool closes_ = false;
};

}  // namespace prosector
