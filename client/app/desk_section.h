#pragma once
// The plane at which a desk user has opened what they see. A key opens it; while the key is held the wheel
// moves the plane; the key pressed again without the wheel closes it.

#include <optional>

#include "client/view/section.h"

namespace prosector {

class DeskSection {
 public:
  /// Opens at a plane through `middle` that faces the eye; `back` points there. An open one may close when
  /// the key is let go.
  void press(const Vec3& back, const Vec3& middle) {
    closes_ = plane_.has_value();
    if (!closes_) plane_ = section_facing(back, middle);
  }
  void let_go() {
    if (closes_) plane_.reset();
    closes_ = false;
  }
  /// Moves the plane away from the eye, or towards it.
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
